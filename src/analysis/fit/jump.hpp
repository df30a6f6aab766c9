// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string_view>

#include "src/analysis/fit/points.hpp"

namespace bagnold::analysis {

/// A sharp change of y by a factor, within few points.
struct Jump {
  double x, error;       ///< middle of the jump; (spacing of the points there) / 12^(1/2)
  double before, after;  ///< y at its ends
};

enum class Direction { up, down };

/// The largest jump of ln y in one direction, from `points` in order of x with y above 0: P2 Fig.
/// 24 (R_v jumps up at phi_B and down at phi_N), P2 Fig. 1 (the drop of P_el at Q_c, whose middle
/// is taken: P2 Sec. III A 2).
///
/// The steepest interval is widened on both sides while ln y changes on at least a third as
/// steeply; the middle is where ln y, interpolated, is half-way between its ends. None if y changes
/// by less than `least_factor` or, with errors, by less than three of them, or if the steepest
/// interval is less than three times as steep as those outside the jump (their median): a power
/// law, in ln x, has no jump. A jump may lie anywhere between two points: that spread, uniform, is
/// the error.
std::optional<Jump> find_jump(Points const& points, Direction direction, double least_factor);

/// Why find_jump() finds none, as messages put it behind "no jump: "; empty where it finds one.
std::string_view why_no_jump(Points const& points, Direction direction, double least_factor);

}  // namespace bagnold::analysis
