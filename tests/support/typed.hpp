// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <tuple>
#include <type_traits>

#include "kernels/physics/laws/laws.hpp"
#include "src/config/scene_physics.hpp"
#include "src/engine/backends.hpp"
#include "tests/support/schemes.hpp"

/// The program's own lists of backends, laws and schemes as the type lists of tests.
namespace bagnold::test {

/// One law on one backend.
template <class L, class S>
struct On {
  using Law = L;
  using Space = S;
};

/// And by one scheme.
template <class L, class Sp, class Sch>
struct OnBy : On<L, Sp> {
  using Scheme = Sch;
};

namespace detail {

template <class... T>
testing::Types<T...> as_types(std::tuple<T...> const*);

template <class Law, class... Space>
std::tuple<On<Law, Space>...> on_each(std::tuple<Space...> const*);

template <class... Law>
auto on_every_backend(std::tuple<Law...> const*)
    -> decltype(std::tuple_cat(on_each<Law>(static_cast<Backends const*>(nullptr))...));

using LawsOnBackends = decltype(on_every_backend(static_cast<Laws const*>(nullptr)));

/// Without the laws that a scheme cannot step.
template <class Law, class Space, class... Scheme>
auto by_each(On<Law, Space>, std::tuple<Scheme...> const*) -> decltype(std::tuple_cat(
    std::conditional_t<Scheme::template can_step<Law>, std::tuple<OnBy<Law, Space, Scheme>>,
                       std::tuple<>>{}...));

template <class... LawOnBackend>
auto by_every_scheme(std::tuple<LawOnBackend...> const*)
    -> decltype(std::tuple_cat(by_each(LawOnBackend{}, static_cast<Schemes const*>(nullptr))...));

using LawsOnBackendsByScheme =
    decltype(by_every_scheme(static_cast<LawsOnBackends const*>(nullptr)));

}  // namespace detail

/// For TYPED_TEST_SUITE: every backend; every law on every backend.
using EveryBackend = decltype(detail::as_types(static_cast<Backends const*>(nullptr)));
using EveryLawOnEveryBackend =
    decltype(detail::as_types(static_cast<detail::LawsOnBackends const*>(nullptr)));
using EveryLawOnEveryBackendByEveryScheme =
    decltype(detail::as_types(static_cast<detail::LawsOnBackendsByScheme const*>(nullptr)));

/// A law at k_d = 1/Q; CD_nt with 0.7 and 1.6 times that, normal and tangential.
template <ContactLaw Law>
Law law_at(double elasticity) {
  Scene::Disks disks;
  disks.elasticity = elasticity;
  disks.damping_normal = 0.7;
  disks.damping_tangential = 1.6;
  return make_law<Law>(disks);
}

/// One trial in how many a backend takes of a costly test: the first backend takes every trial, the
/// others a sample, since on a busy machine each of their launches may wait for a turn.
template <class Space>
constexpr int one_trial_in(int sample) {
  return std::is_same_v<Space, std::tuple_element_t<0, Backends>> ? 1 : sample;
}

/// "serial"; "CD_n_serial"; "CD_n_serial_two_stage_leapfrog".
struct TypeNames {
  template <class T>
  static std::string GetName(int i) {
    if constexpr (requires { typename T::Scheme; }) {
      std::string scheme(T::Scheme::name);
      std::ranges::replace(scheme, '-', '_');
      return GetName<On<typename T::Law, typename T::Space>>(i) + "_" + scheme;
    } else if constexpr (requires { typename T::Law; })
      return std::string(T::Law::name) + "_" + std::string(backend_name<typename T::Space>);
    else
      return std::string(backend_name<T>);
  }
};

}  // namespace bagnold::test
