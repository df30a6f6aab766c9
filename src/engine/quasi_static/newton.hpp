// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/engine/quasi_static/newton_matrix.hpp"

namespace bagnold::quasi_static {

/// Work of a solution.
struct SolveCounts {
  std::int64_t iterations = 0;      ///< of Newton
  std::int64_t factorizations = 0;  ///< of its matrix
  std::int64_t evaluations = 0;     ///< of all forces
};

/// Largest residual force or torque, in units of the mean force in contacts. It changes p by 0.02%.
inline constexpr Real default_tolerance = 1e-3;

/// Solves the equations of a step by Newton's iteration, beginning with the motion at its start.
/// The iteration is semi-smooth: contacts open and close on the way. If a direction leaves more
/// than a tenth of the residual, it goes to where the slope is at most a fifth of that at the start
/// (regula falsi). Without this the iteration cycles.
///
/// Returns whether R is within the tolerance; then `u` is the solution, and the equations are
/// evaluated there.
template <bool Rotates>
bool solve_step(StepEquations<Rotates>& equations, NewtonMatrix<Rotates>& matrix, Real tolerance,
                Eigen::VectorXd& u, SolveCounts& counts);

}  // namespace bagnold::quasi_static
