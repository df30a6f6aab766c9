// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/physics/laws/laws.hpp"
#include "kernels/physics/repulsion/repulsion.hpp"
#include "kernels/physics/type_list.hpp"
#include "src/config/scene.hpp"

/// The law and the repulsion that a scene names, as types of kernels/physics: the one place where
/// words of a scene become formulas. For .cpp files: what only reads scenes needs no formulas.
namespace bagnold {

inline DampingInput damping_input(Scene::Disks const& disks) {
  return {disks.elasticity, disks.damping_normal, disks.damping_tangential};
}

/// use(the law of a scene); a value-initialised result where there is no such law.
template <class Use>
auto with_law(Scene::Disks const& disks, Use const& use) {
  return with_named<Laws>(disks.model, [&]<class Law>(std::type_identity<Law>) {
    return use(Law::make(damping_input(disks)));
  });
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

/// use(the repulsion of a scene); the last one where there is no such exponent.
template <class Use>
auto with_repulsion(Scene::Disks const& disks, Use const& use) {
  return detail::with_exponent(static_cast<Repulsions const*>(nullptr), disks.force_exponent, use);
}

}  // namespace bagnold
