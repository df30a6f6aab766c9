// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "kernels/physics/box/shear_since.hpp"

namespace bagnold {

/// Validity of a list of near pairs: when it was pruned from a wider one, and how far disks have
/// moved.
struct PrunedList {
  ShearMark mark;            ///< of the pruning
  Real nonaffine_bound = 0;  ///< at least the largest |w| since then, [d_s]
  Real margin = 0;           ///< pairs up to d_ij + margin are in it, [d_s]
};

/// Use of a list, which determines its best margin.
struct ListUse {
  std::uint64_t wider = 0;   ///< pairs of the list that it is taken from
  std::uint64_t kept = 0;    ///< pairs in it
  std::uint64_t wanted = 0;  ///< of those, pairs that touch
  Real pruning_cost = 2;     ///< of a pair of the wider list, [cycles]
  Real step_cost = 25;       ///< of a pair kept, each step, [cycles]
  Real fewest_steps = 4;     ///< that it must hold
  Real per_step = 0;         ///< by which the margin is used up at most, 2 dt u, [d_s]
};

/// Margin at which a step costs least. A pruning costs c_o for each wider pair and lasts margin/(2
/// dt u) steps, u being the largest peculiar speed. A step costs c_i for each pair kept, of which a
/// share proportional to the margin does not touch. So margin^2 = 2 dt u c_o n_wider margin/(c_i
/// n_idle).
inline Real best_margin(ListUse const& use, Real margin, Real skin) {
  constexpr Real first_margin = 0.015;
  if (use.kept == 0) return std::min(skin, margin == 0 ? first_margin : margin);
  Real const idle = use.kept > use.wanted ? static_cast<Real>(use.kept - use.wanted) : 1;
  Real const best = std::sqrt(use.per_step * margin * use.pruning_cost / use.step_cost *
                              static_cast<Real>(use.wider) / idle);
  return std::clamp(best, std::min(skin, use.fewest_steps * use.per_step), skin);
}

}  // namespace bagnold
