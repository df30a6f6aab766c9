// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/device/dynamics/contact_forces.hpp"
#include "src/engine/contacts/contact_record.hpp"

namespace bagnold {

/// Sees contacts begin and end from the rows of a full list, on the host, pair by pair: plain, and
/// what ContactDetector is held against.
/// Where velocities of contacts are asked for, they are sampled last, as ContactRecord wants it.
template <ContactLaw Law, class Repulsion, class Space>
void detect_along_rows(ContactForces<Law, Repulsion, Space> const& forces, std::int64_t step,
                       Sampling const& sampling, OpenWindows& windows) {
  auto const on_host = [](auto const& view) {
    return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, view);
  };
  auto const row = on_host(forces.neighbors.row);
  auto const entries = on_host(forces.neighbors.entries);
  auto const position = on_host(forces.position);
  auto const motion = on_host(forces.motion);
  auto const species = on_host(forces.species);
  ContactRecord& record = *windows.contacts;
  std::vector<ContactEvent> events;
  std::vector<ContactSample> touched;
  std::vector<ContactPick> picks;
  ContactMotion sums;
  ContactPicker const picker = record.picker();
  bool const sampled = sampling.sampled(step);
  auto const spin = [&](std::uint32_t i, std::uint32_t j) {
    if constexpr (Law::rotates) {
      Real const a = forces.table.diameter[species(i)], b = forces.table.diameter[species(j)];
      return (a * motion(i).spin + b * motion(j).spin) / (a + b);
    }
    return Real{0};
  };
  for (std::uint32_t i = 0; i < position.extent(0); ++i)
    for (auto k = row(i); k < row(i + 1); ++k) {
      auto const j = entries(k).index();
      if (j < i) continue;
      Image const image = entries(k).image();
      Vec2<Real> const separation = (position(i) - position(j)) - forces.box.shift(image);
      Real const distance =
          (forces.table.diameter[species(i)] + forces.table.diameter[species(j)]) / 2;
      bool const touching = dot(separation, separation) < distance * distance;
      if (!touching && !record.table.is_open(i, j)) continue;
      Vec2<Real> velocity = motion(i).velocity - motion(j).velocity;
      velocity.x -= forces.box.velocity_shift(image);
      auto const velocities = [&] {
        return contact_velocities(separation, velocity, spin(i, j), forces.box.strain_rate);
      };
      if (touching && sampled) {
        sums.add(1, separation, velocity, spin(i, j));
        picker(picks, step, i, j, velocities);
      }
      if (touching && record.choice) touched.push_back({step, i, j, velocities()});
      if (touching != record.table.is_open(i, j))
        events.push_back(contact_event(step, touching, i, j, separation, velocity));
    }
  if (sampled) record.add(sums, step, sampling, windows);
  record.add(picks);
  record.add(events, sampling, windows);
  for (auto const& sample : touched)
    if (record.table.find(sample.a, sample.b)->due == step) record.add(sample);
  record.evaluated(step, step + 1, sampling, windows);
}

}  // namespace bagnold
