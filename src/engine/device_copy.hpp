// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Core.hpp>
#include <string>

#include "kernels/physics/motion.hpp"
#include "kernels/physics/species.hpp"
#include "src/state/state.hpp"

/// Copies between host vectors, in the order of the start, and Views.
namespace bagnold {

/// A vector as a View; it must outlive the View.
template <class T>
auto view_of(std::vector<T>& host) {
  return Kokkos::View<T*, Kokkos::HostSpace, Kokkos::MemoryUnmanaged>(host.data(), host.size());
}
template <class T>
auto view_of(std::vector<T> const& host) {
  return Kokkos::View<T const*, Kokkos::HostSpace, Kokkos::MemoryUnmanaged>(host.data(),
                                                                            host.size());
}

template <class Space, class T>
Kokkos::View<T*, Space> to_device(std::string const& label, std::vector<T> const& host) {
  Kokkos::View<T*, Space> device(Kokkos::view_alloc(Kokkos::WithoutInitializing, label),
                                 host.size());
  Kokkos::deep_copy(device, view_of(host));
  return device;
}

template <class T, class Space>
std::vector<T> to_host(Kokkos::View<T*, Space> const& device) {
  std::vector<T> host(device.extent(0));
  Kokkos::deep_copy(view_of(host), device);
  return host;
}

inline std::vector<Vec2<Real>> vectors(std::vector<std::array<double, 2>> const& pairs) {
  std::vector<Vec2<Real>> result(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) result[i] = {pairs[i][0], pairs[i][1]};
  return result;
}

inline std::vector<std::array<double, 2>> pairs(std::vector<Vec2<Real>> const& vectors) {
  std::vector<std::array<double, 2>> result(vectors.size());
  for (std::size_t i = 0; i < vectors.size(); ++i) result[i] = {vectors[i].x, vectors[i].y};
  return result;
}

template <bool Rotates>
std::vector<Motion<Rotates>> motions(State const& state) {
  std::vector<Motion<Rotates>> result(state.count());
  for (std::size_t i = 0; i < state.count(); ++i) {
    result[i].velocity = {state.velocity[i][0], state.velocity[i][1]};
    if constexpr (Rotates) result[i].spin = state.spin[i];
  }
  return result;
}

template <bool Rotates>
void split_motions(std::vector<Motion<Rotates>> const& motions, State& state) {
  state.velocity.resize(motions.size());
  if constexpr (Rotates) state.spin.resize(motions.size());
  for (std::size_t i = 0; i < motions.size(); ++i) {
    state.velocity[i] = {motions[i].velocity.x, motions[i].velocity.y};
    if constexpr (Rotates) state.spin[i] = motions[i].spin;
  }
}

inline std::vector<Species> species_of(std::vector<double> const& diameter) {
  std::vector<Species> result(diameter.size());
  for (std::size_t i = 0; i < diameter.size(); ++i)
    result[i] = diameter[i] > (small_diameter + big_diameter) / 2 ? 1 : 0;
  return result;
}

}  // namespace bagnold
