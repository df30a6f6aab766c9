// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/config/piece_table.hpp"

namespace bagnold {

struct Scene;

/// Pieces of a scene with shear.protocol = "sequence", each of the nearest whole number of steps.
/// Throws InputError where they are too many steps.
PieceTable make_sequence(Scene const& scene);

}  // namespace bagnold
