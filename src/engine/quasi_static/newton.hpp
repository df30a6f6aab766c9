// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/engine/quasi_static/newton_matrix.hpp"

namespace bagnold::quasi_static {

/// What solving took.
struct SolveCounts {
  std::int64_t iterations = 0;      ///< of Newton
  std::int64_t factorizations = 0;  ///< of its matrix
  std::int64_t evaluations = 0;     ///< of all forces
};

/// Largest force or torque left over, in units of the mean force in contacts: it changes p by
/// 0.02%.
inline constexpr Real default_tolerance = 1e-3;

/// Solves the equations of a step that began, by Newton's iteration from the motion then. It is
/// semi-smooth: contacts open and close on the way. Along a direction that leaves more than a
/// tenth it goes to where the slope is at most a fifth of that at the start (regula falsi), without
/// which it cycles.
///
/// Returns whether R is within the tolerance; then `u` is the solution, and the equations are
/// evaluated there.
template <bool Rotates>
bool solve_step(StepEquations<Rotates>& equations, NewtonMatrix<Rotates>& matrix, Real tolerance,
                Eigen::VectorXd& u, SolveCounts& counts);

}  // namespace bagnold::quasi_static
