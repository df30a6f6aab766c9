// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/physics/schemes/schemes.hpp"
#include "kernels/physics/type_list.hpp"
#include "src/config/laws.hpp"
#include "src/config/scene_physics.hpp"

namespace bagnold {

namespace detail {

template <ContactLaw Law>
LawConstants constants(Scene::Disks const& disks) {
  if constexpr (Law::linear) {
    Law const law = Law::make(damping_input(disks));
    return {law.normal_damping(), law.tangential_damping()};
  } else {
    return static_cast<void>(disks), LawConstants{};
  }
}

template <ContactLaw Law>
double paper_time_step(double elasticity) {
  return Law::paper_time_step(elasticity);
}

template <ContactLaw Law>
double rule_time_step(std::string_view scheme, Scene::Disks const& disks) {
  return with_named<Schemes>(scheme, [&]<class S>(std::type_identity<S>) -> double {
    if constexpr (S::template can_step<Law>)
      return S::template time_step<Law>(damping_input(disks));
    else
      return Law::paper_time_step(disks.elasticity);  // refused by name where it is run
  });
}

}  // namespace detail

template <ContactLaw Law>
LawFacts facts_of() {
  return {Law::name,
          Law::rotates,
          Law::separate_constants,
          Law::linear,
          detail::constants<Law>,
          detail::paper_time_step<Law>,
          detail::rule_time_step<Law>};
}

}  // namespace bagnold
