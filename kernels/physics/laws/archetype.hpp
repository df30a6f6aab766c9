// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/physics/laws/linear_damping.hpp"

namespace bagnold {

/// The least that a linear law has: checks of templates use it, so that they depend on no law of
/// the list.
struct ArchetypeLaw : LinearDamping<false, false> {
  static constexpr std::string_view name = "archetype";

  static Real paper_time_step(Real) { return 0.1; }
  static ArchetypeLaw make(DampingInput const& input) { return {1 / input.elasticity}; }
};
static_assert(is_contact_law<ArchetypeLaw>());

}  // namespace bagnold
