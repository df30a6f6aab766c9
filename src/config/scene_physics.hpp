// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tuple>

#include "kernels/physics/laws/contact.hpp"
#include "kernels/physics/repulsion/repulsion.hpp"
#include "src/config/scene.hpp"

/// Repulsion of a scene as a type of kernels/physics, and the input of its law. For .cpp files:
/// code that only reads scenes needs no formulas.
namespace bagnold {

inline DampingInput damping_input(Scene::Disks const& disks) {
  return {disks.elasticity, disks.damping_normal, disks.damping_tangential};
}

namespace detail {

template <class First, class... Other, class Use>
auto with_exponent(std::tuple<First, Other...> const*, double exponent, Use const& use) {
  if constexpr (sizeof...(Other) > 0)
    if (exponent != First::force_exponent)
      return with_exponent(static_cast<std::tuple<Other...> const*>(nullptr), exponent, use);
  return use(First{});
}

}  // namespace detail

/// Calls use(the repulsion of a scene); the last one if there is no such exponent.
template <class Use>
auto with_repulsion(Scene::Disks const& disks, Use const& use) {
  return detail::with_exponent(static_cast<Repulsions const*>(nullptr), disks.force_exponent, use);
}

}  // namespace bagnold
