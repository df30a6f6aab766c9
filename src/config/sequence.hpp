// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/config/piece_table.hpp"

namespace bagnold {

struct Scene;

/// Pieces of a scene with shear.protocol = "sequence", each of the nearest whole number of steps:
/// strains are those asked for, rates change by at most 1%. Throws InputError where they would
/// change by more, or where steps are too many.
PieceTable make_sequence(Scene const& scene);

}  // namespace bagnold
