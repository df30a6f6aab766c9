// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tuple>
#include <type_traits>

#include "kernels/physics/laws/cd.hpp"
#include "kernels/physics/laws/cd_n.hpp"
#include "kernels/physics/laws/cd_rot.hpp"
#include "kernels/physics/laws/general.hpp"
#include "kernels/physics/repulsion/repulsion.hpp"
#include "src/config/scene.hpp"

namespace bagnold {

/// Every contact law there is: the program, its messages and its typed tests read this list.
using Laws = std::tuple<CD, CDn, CDrot, General>;

/// The law with the constants of a scene: k_d = 1/Q (P1 Eq. 6, P2 Eq. 9).
template <ContactLaw Law>
Law make_law(Scene::Disks const& disks) {
  double const damping = 1.0 / disks.elasticity;
  if constexpr (std::is_same_v<Law, General>)
    return {disks.damping_normal * damping, disks.damping_tangential * damping};
  else
    return {damping};
}

/// use(repulsion) with the repulsion of a scene.
template <class Use>
auto with_repulsion(Scene::Disks const& disks, Use const& use) {
  if (disks.force_exponent == HertzianRepulsion::force_exponent) return use(HertzianRepulsion{});
  return use(HarmonicRepulsion{});
}

}  // namespace bagnold
