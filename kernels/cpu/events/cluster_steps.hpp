// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

#include "kernels/cpu/events/cluster.hpp"
#include "kernels/cpu/events/image_shifts.hpp"
#include "kernels/cpu/events/linear_damping.hpp"
#include "kernels/cpu/events/tournament.hpp"
#include "kernels/physics/laws/pair_force.hpp"
#include "kernels/physics/repulsion/repulsion.hpp"

namespace bagnold::events {

/// Of a step of a cluster, at most: the phase of a lone contact's oscillation, and the exponent by
/// which its damping acts.
inline constexpr Real longest_phase = 0.35, longest_decay = 0.4;

/// What acts between disks, and what they are.
template <bool Rotates>
struct Material {
  SpeciesTable table;
  LinearDamping<Rotates> damping;
  ContactClasses<Rotates> classes;
  Real longest_step = 0;  ///< of a cluster, [tau_e]

  static Material of(LinearDamping<Rotates> const& damping, SpeciesTable const& table) {
    Material material{table, damping, {}};
    Real fastest = 0;
    for (Species i = 0; i < 2; ++i)
      for (Species j = 0; j < 2; ++j)
        material.classes.of[i][j] =
            ContactClass<Rotates>::of_constants(damping.normal, damping.tangential, table, i, j);
    for (auto const& row : material.classes.of)
      for (auto const& c : row)
        fastest = std::max({fastest, c.frequency0 / longest_phase,
                            2 * c.rates.damping / longest_decay, c.rates.sliding / longest_decay});
    material.longest_step = 1 / fastest;
    return material;
  }
};

/// Steps of clusters, by the classical Runge-Kutta scheme of fourth order.
///
/// Nothing begins or ends within a step: it is cut where the first contact parts, at the root of
/// the overlap on the cubics of the step, and by the queue where another disk is hit. So the force
/// is smooth in it and the order holds.
template <bool Rotates>
class ClusterSteps {
 public:
  ClusterSteps(Material<Rotates> const& material, ImageShifts const& shifts)
      : material_(&material), shifts_(&shifts) {}

  /// The step that begins at cluster.time from the begin of its members, to where the first contact
  /// parts.
  void plan(Cluster<Rotates>& cluster) {
    plan(cluster, material_->longest_step);
    int ending = -1;
    Real end = cluster.step;
    for (std::size_t k = 0; k < cluster.links.size(); ++k)
      if (Real const parts = parting(cluster, cluster.links[k]); parts < end) {
        end = parts;
        ending = static_cast<int>(k);
      }
    cluster.ending = ending;
    if (ending < 0) return;
    Real const least = 1e-12 * material_->longest_step;
    plan(cluster, std::max(end, least));
    // the root was that of the cubic of a longer step
    auto const [width, rate] =
        gap(cluster, cluster.links[static_cast<std::size_t>(ending)], cluster.step);
    Real const late = width / rate;
    if (rate > 0 && std::fabs(late) > 1e-9 * cluster.step && std::fabs(late) < cluster.step / 2)
      plan(cluster, std::max(cluster.step - late, least));
  }

  /// A step of a given length.
  void plan(Cluster<Rotates>& cluster, Real step) {
    auto const n = cluster.members.size();
    cluster.step = step;
    for (auto* stage : {&first_, &second_, &third_, &fourth_}) stage->resize(n);
    trial_.resize(n);
    auto& members = cluster.members;
    auto const moved = [&](Real s, std::vector<Change> const* by) {
      for (std::size_t a = 0; a < n; ++a) {
        auto const& from = members[a].begin;
        trial_[a] = from;
        if (!by) continue;
        auto const& change = (*by)[a];
        trial_[a].position += s * change.velocity;
        trial_[a].motion.velocity += s * change.force;
        if constexpr (Rotates) trial_[a].motion.spin += s * change.torque;
      }
    };
    moved(0, nullptr);
    evaluate(cluster, cluster.time, first_);
    moved(step / 2, &first_);
    evaluate(cluster, cluster.time + step / 2, second_);
    moved(step / 2, &second_);
    evaluate(cluster, cluster.time + step / 2, third_);
    moved(step, &third_);
    evaluate(cluster, cluster.time + step, fourth_);
    for (std::size_t a = 0; a < n; ++a) {
      auto const &k1 = first_[a], &k2 = second_[a], &k3 = third_[a], &k4 = fourth_[a];
      auto& m = members[a];
      m.end = m.begin;
      Real const sixth = step / 6;
      m.end.position += sixth * (k1.velocity + 2.0 * (k2.velocity + k3.velocity) + k4.velocity);
      m.end.motion.velocity += sixth * (k1.force + 2.0 * (k2.force + k3.force) + k4.force);
      m.turn = k1.torque;
      if constexpr (Rotates)
        m.end.motion.spin += sixth * (k1.torque + 2 * (k2.torque + k3.torque) + k4.torque);
      m.join(step);
    }
  }

  /// r_ab at a phase s of the step, [d_s], and v_ab.
  Vec2<Real> separation(Cluster<Rotates> const& cluster, Link const& link, Real s) const {
    return cluster.members[link.a].position(s) - cluster.members[link.b].position(s) -
           (*shifts_)(link.other).at(cluster.time + s);
  }
  Vec2<Real> velocity(Cluster<Rotates> const& cluster, Link const& link, Real s) const {
    Vec2<Real> v = cluster.members[link.a].velocity(s) - cluster.members[link.b].velocity(s);
    v.x -= (*shifts_)(link.other).velocity;
    return v;
  }
  Real distance(Cluster<Rotates> const& cluster, Link const& link) const {
    return class_distance(
        pair_class(cluster.members[link.a].species, cluster.members[link.b].species));
  }

  /// The force of a link at a phase; motion(member) gives the members'.
  template <class Motions>
  PairForce<Real> force(Cluster<Rotates> const& cluster, Link const& link, Real time,
                        Motions const& motion) const {
    auto const &a = cluster.members[link.a], &b = cluster.members[link.b];
    auto const &i = motion(link.a), &j = motion(link.b);
    auto const& shift = (*shifts_)(link.other);
    auto const r = i.position - j.position - shift.at(time);
    auto v = i.motion.velocity - j.motion.velocity;
    v.x -= shift.velocity;
    Real const inverse_distance = inverse_class_distance(pair_class(a.species, b.species));
    Real spins = 0;
    if constexpr (Rotates)
      spins = material_->table.diameter[a.species] * i.motion.spin +
              material_->table.diameter[b.species] * j.motion.spin;
    return pair_force(material_->damping, HarmonicRepulsion{}, r, dot(r, r), v, inverse_distance,
                      spins);
  }

 private:
  /// Time derivatives of position, velocity and spin.
  struct Change {
    Vec2<Real> velocity, force;
    Real torque;
  };

  void evaluate(Cluster<Rotates> const& cluster, Real time, std::vector<Change>& to) {
    auto const& table = material_->table;
    for (std::size_t a = 0; a < to.size(); ++a) to[a] = {trial_[a].motion.velocity, {}, 0};
    auto const motion = [&](std::uint32_t m) -> DiskMotion<Rotates> const& { return trial_[m]; };
    for (auto const& link : cluster.links) {
      auto const pair = force(cluster, link, time, motion);
      auto const f = pair.elastic + pair.dissipative;
      auto const a = cluster.members[link.a].species, b = cluster.members[link.b].species;
      to[link.a].force += table.inverse_mass[a] * f;
      to[link.b].force += -table.inverse_mass[b] * f;
      if constexpr (Rotates) {
        Real const torque = pair.torque_per_diameter(inverse_class_distance(pair_class(a, b)));
        to[link.a].torque += table.inverse_inertia[a] * table.diameter[a] * torque;
        to[link.b].torque += table.inverse_inertia[b] * table.diameter[b] * torque;
      }
    }
  }

  /// r - d of a link at a phase, [d_s], and its rate.
  std::pair<Real, Real> gap(Cluster<Rotates> const& cluster, Link const& link, Real s) const {
    auto const r = separation(cluster, link, s), v = velocity(cluster, link, s);
    Real const width = std::sqrt(dot(r, r));
    return {width - distance(cluster, link), dot(r, v) / width};
  }

  /// The phase at which a contact parts, or infinity: Newton's method in a bracket.
  Real parting(Cluster<Rotates> const& cluster, Link const& link) const {
    Real low = 0, high = cluster.step;
    auto [width, rate] = gap(cluster, link, high);
    if (width < 0) {  // parted and met again in between, if at all
      Real const at_first = gap(cluster, link, 0).second;
      if (!(at_first > 0 && rate < 0)) return never;
      high *= at_first / (at_first - rate);
      std::tie(width, rate) = gap(cluster, link, high);
      if (width < 0) return never;
    }
    Real s = high;
    for (int n = 0; n < 60; ++n) {
      (width > 0 ? high : low) = s;
      Real next = rate > 0 ? s - width / rate : (low + high) / 2;
      if (!(next > low && next < high)) next = (low + high) / 2;
      if (std::fabs(next - s) < 1e-14 * cluster.step) return next;
      s = next;
      std::tie(width, rate) = gap(cluster, link, s);
    }
    return s;
  }

  Material<Rotates> const* material_;
  ImageShifts const* shifts_;
  std::vector<DiskMotion<Rotates>> trial_;
  std::vector<Change> first_, second_, third_, fourth_;
};

}  // namespace bagnold::events
