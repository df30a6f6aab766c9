// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/quasi_static/step_equations.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "kernels/physics/repulsion/repulsion.hpp"
#include "src/engine/quasi_static/step_damping.hpp"

namespace bagnold::quasi_static {

template <bool Rotates>
StepEquations<Rotates>::StepEquations(Material material)
    : material_(std::move(material)),
      inertia_(unknowns * static_cast<Eigen::Index>(material_.species.size())) {
  for (std::size_t i = 0; i < material_.species.size(); ++i) {
    auto const s = material_.species[i];
    auto const at = unknowns * static_cast<Eigen::Index>(i);
    inertia_[at] = inertia_[at + 1] = 1 / material_.table.inverse_mass[s];
    if (Rotates) inertia_[at + 2] = 1 / material_.table.inverse_inertia[s];
    mass_ += inertia_[at];
  }
}

template <bool Rotates>
void StepEquations<Rotates>::begin(StepStart start, std::vector<NearPair> const& pairs) {
  start_ = std::move(start);
  pairs_ = &pairs;
  position_.resize(start_.position.size());
  overlap_before_.resize(pairs.size());
  overlap_.resize(pairs.size());
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    auto const r = pairs[k].separation(start_.position, start_.before);
    overlap_before_[k] = pairs[k].distance - std::sqrt(dot(r, r));
  }
}

template <bool Rotates>
void StepEquations<Rotates>::evaluate(Eigen::VectorXd const& u, bool glued) {
  Real const h = start_.duration;
  residual_ = inertia_.cwiseProduct(u - start_.motion);
  for (std::size_t i = 0; i < position_.size(); ++i) {
    auto const at = unknowns * static_cast<Eigen::Index>(i);
    position_[i] = start_.position[i] + h * Vec2<Real>{u[at], u[at + 1]};
  }
  active_.clear();
  for (std::uint32_t k = 0; k < pairs_->size(); ++k) add(k, u, glued);
}

template <bool Rotates>
void StepEquations<Rotates>::add(std::uint32_t number, Eigen::VectorXd const& u, bool glue) {
  NearPair const& pair = (*pairs_)[number];
  Real const overlap_before = overlap_before_[number];
  auto const r = pair.separation(position_, start_.after);
  Real const distance2 = dot(r, r), h = start_.duration;
  bool const touched = overlap_before > 0, glued = glue && touched;
  bool const touches = glued || distance2 < pair.distance * pair.distance;
  if (!touches && !touched) {
    overlap_[number] = (pair.distance * pair.distance - distance2) / (2 * pair.distance);
    return;
  }
  Real const overlap = overlap_[number] = pair.distance - std::sqrt(distance2);
  Real const path = glued ? 1 : path_in_contact(overlap_before, overlap);
  StepDamping<Rotates> const damping{path * material_.normal_damping,
                                     touched ? material_.tangential_damping : 0};
  auto const i = unknowns * static_cast<Eigen::Index>(pair.i);
  auto const j = unknowns * static_cast<Eigen::Index>(pair.j);
  Vec2<Real> const velocity{u[i] - u[j] - start_.after.velocity_shift(pair.image),
                            u[i + 1] - u[j + 1]};
  Real const diameter_i = material_.diameter(pair.i), diameter_j = material_.diameter(pair.j);
  Real const inverse_distance = 1 / pair.distance;
  Real spins = 0;
  if constexpr (Rotates) spins = u[i + 2] * diameter_i + u[j + 2] * diameter_j;
  HarmonicRepulsion const repulsion;
  auto force = pair_force(damping, repulsion, r, distance2, velocity, inverse_distance, spins);
  if (!touches) force.elastic = {};

  Vec2<Real> const total = force.elastic + force.dissipative;
  residual_[i] -= h * total.x;
  residual_[i + 1] -= h * total.y;
  residual_[j] += h * total.x;
  residual_[j + 1] += h * total.y;
  if constexpr (Rotates) {
    Real const torque = h * force.torque_per_diameter(inverse_distance);
    residual_[i + 2] -= diameter_i * torque;
    residual_[j + 2] -= diameter_j * torque;
  }
  Real const stiffness =
      repulsion.stiffness(force.relative_overlap) * inverse_distance * inverse_distance;
  active_.push_back({number, pair.i, pair.j, force, touches, diameter_i / (diameter_i + diameter_j),
                     diameter_j / (diameter_i + diameter_j),
                     touches ? h * h * stiffness + h * material_.normal_damping : 0,
                     h * damping.tangential});
}

template <bool Rotates>
Real StepEquations<Rotates>::relative_residual() const {
  if (!residual_.allFinite()) return std::numeric_limits<Real>::infinity();
  Real sum = 0;
  int contacts = 0;
  for (auto const& pair : active_) {
    if (!pair.touches) continue;
    sum += std::sqrt(dot(pair.force.elastic, pair.force.elastic));
    ++contacts;
  }
  Real const slow = (material_.normal_damping + material_.tangential_damping) *
                    std::abs(start_.after.strain_rate) * small_diameter;
  Real const force = std::max(contacts > 0 ? sum / contacts : 0, slow);
  Real const left = residual_.cwiseAbs().maxCoeff() / start_.duration;
  return left > 0 ? left / force : 0;
}

template <bool Rotates>
void StepEquations<Rotates>::keep_momentum(Eigen::VectorXd& u) const {
  for (Eigen::Index a = 0; a < 2; ++a) {
    Real sum = 0;
    for (auto k = a; k < u.size(); k += unknowns) sum += inertia_[k] * (u[k] - start_.motion[k]);
    for (auto k = a; k < u.size(); k += unknowns) u[k] -= sum / mass_;
  }
}

template class StepEquations<false>;
template class StepEquations<true>;

}  // namespace bagnold::quasi_static
