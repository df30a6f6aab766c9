// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "kernels/device/dynamics/relaxation.hpp"
#include "src/engine/failure.hpp"

namespace bagnold {

/// Throws the NumericalError of a system with a NaN or an overlap beyond its limit. forces: at
/// `step`; state: at that step; original: index in it of the disk at a place of `forces`.
template <ContactLaw Law, class Repulsion, class Space, class Original = std::identity>
[[noreturn]] void throw_unsound(Space const& space,
                                ContactForces<Law, Repulsion, Space> const& forces,
                                Clock const& clock, std::int64_t step, State const& state,
                                Original const& original = {}) {
  failure::check_finite(clock, step, state);
  Kokkos::ValLocScalar<Real, std::int64_t> deepest{};
  side_by_side::parallel_reduce("dynamics::LargestOverlap",
                                Kokkos::RangePolicy<Space, Kokkos::IndexType<std::int64_t>>(
                                    space, 0, static_cast<std::int64_t>(state.count())),
                                LargestOverlap<Law, Repulsion, Space>{forces},
                                Kokkos::MaxLoc<Real, std::int64_t>(deepest));
  failure::too_deep(clock, step, original(static_cast<std::size_t>(deepest.loc)), deepest.val);
}

}  // namespace bagnold
