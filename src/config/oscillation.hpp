// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/config/piece_table.hpp"

namespace bagnold {

struct Scene;

/// T of a scene with shear.protocol = "oscillate", from shear.period or shear.peak_rate =
/// gamma_0 2 pi / T, [tau_e].
double oscillation_period(Scene const& scene);

/// Pieces of that scene: gamma = gamma_0 sin(2 pi t / T) where they begin, exactly, and linear in
/// between; K pieces a cycle. Throws InputError where the time step does not divide them, or for
/// too many steps.
PieceTable make_oscillation(Scene const& scene);

}  // namespace bagnold
