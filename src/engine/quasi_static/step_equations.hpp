// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "kernels/physics/laws/pair_force.hpp"
#include "src/engine/quasi_static/near_pairs.hpp"

namespace bagnold::quasi_static {

/// Constants of the equations: species of each disk and damping.
struct Material {
  std::vector<Species> species;  ///< [N]
  SpeciesTable table;
  Real normal_damping, tangential_damping;  ///< k_n, k_t, [m / tau_e]

  Real diameter(std::uint32_t i) const { return table.diameter[species[i]]; }
};

/// Beginning and duration of a step.
struct StepStart {
  std::vector<Vec2<Real>> position;  ///< [N], [d_s]
  Eigen::VectorXd motion;            ///< {v_x, v_y} or {v_x, v_y, thetadot} of each disk
  Real duration = 0;                 ///< h, [tau_e]
  ShearedBox before{}, after{};      ///< the box where it begins and where it ends
};

/// A pair that acts on its disks in a step.
struct ActivePair {
  std::uint32_t number;  ///< among the pairs of the list
  std::uint32_t i, j;
  PairForce<Real> force;  ///< where the step ends
  bool touches;           ///< there
  Real share_i, share_j;  ///< d_i/(d_i + d_j) and d_j/(d_i + d_j)
  Real normal;            ///< h^2 k + h s' k_n: change of the impulse with the velocity, [m]
  Real tangential;        ///< h s_t k_t, [m]
};

/// Equations of one step of backward Euler, with forces at the new positions:
///
///     R(u) = M (u - v) - h F(r + h u, u) = 0
///
/// u: velocities, and spins where disks rotate, at its end; damping: StepDamping. R is the gradient
/// of a convex function of u, except for the rotation of contacts in the step.
template <bool Rotates>
class StepEquations {
 public:
  static constexpr int unknowns = Rotates ? 3 : 2;  ///< of a disk

  explicit StepEquations(Material material);

  /// Begins a step. pairs: all that may touch in it; they must outlive the step.
  void begin(StepStart start, std::vector<NearPair> const& pairs);

  /// Evaluates R(u), [m d_s / tau_e]. glued: springs of pairs that touched at the beginning of the
  /// step also pull if they are stretched; a first guess that keeps the network together.
  void evaluate(Eigen::VectorXd const& u, bool glued);

  StepStart const& start() const { return start_; }
  Real tangential_damping() const { return material_.tangential_damping; }
  Eigen::VectorXd const& residual() const { return residual_; }
  std::vector<Vec2<Real>> const& position() const { return position_; }  ///< r + h u
  std::vector<ActivePair> const& active() const { return active_; }

  std::vector<NearPair> const& pairs() const { return *pairs_; }

  /// Overlap d_ij - r_ij of each pair at the end of the step, [d_s]; (d_ij^2 - r_ij^2)/(2 d_ij),
  /// equal to first order, for pairs that are apart before and after.
  std::vector<Real> const& overlap() const { return overlap_; }

  /// Error of a solution: max |R|/h of forces and torques over the mean elastic force in contacts,
  /// or over (k_n + k_t) gammadot d_s where the mean force is smaller.
  Real relative_residual() const;

  Eigen::VectorXd const& inertia() const { return inertia_; }  ///< M: m, m, I of each disk

  /// Removes from u the mean motion that the equations do not allow: sum m (u - v) = 0.
  void keep_momentum(Eigen::VectorXd& u) const;

 private:
  void add(std::uint32_t number, Eigen::VectorXd const& u, bool glue);

  Material material_;
  Eigen::VectorXd inertia_;
  Real mass_ = 0;  ///< of all
  StepStart start_;
  std::vector<NearPair> const* pairs_ = nullptr;
  std::vector<Real> overlap_before_;  ///< d_ij - r_ij of each pair, [d_s]
  std::vector<Real> overlap_;
  std::vector<Vec2<Real>> position_;
  std::vector<ActivePair> active_;
  Eigen::VectorXd residual_;
};

}  // namespace bagnold::quasi_static
