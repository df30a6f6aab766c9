// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "kernels/cpu/events/cluster.hpp"
#include "kernels/cpu/events/cluster_series.hpp"
#include "kernels/cpu/events/first_touch.hpp"
#include "kernels/cpu/events/image_shifts.hpp"
#include "kernels/cpu/events/material.hpp"
#include "kernels/cpu/events/tournament.hpp"

namespace bagnold::events {

/// Steps of clusters: Taylor series in time of all positions, as long as an error of a part in
/// 10^4 of the relative velocities allows.
///
/// Nothing begins or ends within a step: it ends where the first contact parts, at the root of the
/// overlap's series, and is cut by the queue where another disk is hit. So the force is smooth in
/// it and the order holds; and a step that is cut needs no other series.
template <bool Rotates>
class ClusterSteps {
 public:
  ClusterSteps(Material<Rotates> const& material, ImageShifts const& shifts)
      : material_(&material), shifts_(&shifts), series_(material, shifts) {}

  /// The step that begins at cluster.time from the begin of its members, to where the first contact
  /// parts.
  void plan(Cluster<Rotates>& cluster) {
    series_.find(cluster);
    cluster.step = longest(cluster);
    cluster.ending = -1;
    Real end = cluster.step;
    for (std::size_t k = 0; k < cluster.links.size(); ++k)
      if (Real const parts = parting(series_[k], distance(cluster, cluster.links[k]), end);
          parts < end) {
        end = parts;
        cluster.ending = static_cast<int>(k);
      }
    cluster.step = std::max(end, 1e-12 * material_->longest_step);
    for (auto& m : cluster.members) m.bound(cluster.step);
  }

  /// r_ab at a phase s of the step, [d_s], and v_ab.
  template <class T>
  Vec2<T> separation(Cluster<Rotates> const& cluster, Link const& link, T const& s) const {
    auto const& shift = (*shifts_)(link.other);
    auto r = cluster.members[link.a].position(s) - cluster.members[link.b].position(s);
    r.x = r.x - (T(shift.place.x) + T(shift.velocity) * (T(cluster.time) + s));
    r.y = r.y - T(shift.place.y);
    return r;
  }
  template <class T>
  Vec2<T> velocity(Cluster<Rotates> const& cluster, Link const& link, T const& s) const {
    auto v = cluster.members[link.a].velocity(s) - cluster.members[link.b].velocity(s);
    v.x = v.x - T((*shifts_)(link.other).velocity);
    return v;
  }
  /// Relative overlap of link n at the begin of the step that was planned last.
  Real relative_overlap(Cluster<Rotates> const& cluster, std::size_t n) const {
    return 1 - series_[n].u[0] * series_[n].q[0] / distance(cluster, cluster.links[n]);
  }
  Real distance(Cluster<Rotates> const& cluster, Link const& link) const {
    return class_distance(
        pair_class(cluster.members[link.a].species, cluster.members[link.b].species));
  }

 private:
  static constexpr Real tolerance = 1e-4;  ///< of the relative velocities, a step

  /// The longest step whose error is small: that of velocities, from their last terms.
  Real longest(Cluster<Rotates> const& cluster) const {
    constexpr int last = series_order;
    Real scale2 = 0, last2 = 0, before2 = 0;
    for (std::size_t k = 0; k < series_.size(); ++k) {
      auto const& s = series_[k];
      auto const &a = cluster.members[cluster.links[k].a], &b = cluster.members[cluster.links[k].b];
      auto const& c = material_->classes(a.species, b.species);
      Real const overlap = c.distance - s.u[0] * s.q[0];
      scale2 =
          std::max(scale2, s.x[1] * s.x[1] + s.y[1] * s.y[1] + c.frequency02 * overlap * overlap);
    }
    for (auto const& m : cluster.members) {
      last2 = std::max(last2, m.x[last] * m.x[last] + m.y[last] * m.y[last]);
      before2 = std::max(before2, m.x[last - 1] * m.x[last - 1] + m.y[last - 1] * m.y[last - 1]);
    }
    Real const scale = tolerance * std::sqrt(scale2), longest = material_->longest_step;
    constexpr Real shorter = 0.9, power_shorter = power<last - 2>(shorter);
    Real const at_last = last * std::sqrt(last2), before = (last - 1) * std::sqrt(before2);
    Real step = longest, power_of_step = power<last - 2>(longest);
    while (at_last * step * power_of_step > scale || before * power_of_step > 8 * scale) {
      step *= shorter;
      power_of_step *= power_shorter;
    }
    return step;
  }

  template <int n>
  static constexpr Real power(Real x) {
    Real all = 1;
    for (int k = 0; k < n; ++k) all *= x;
    return all;
  }

  /// The phase at which a contact parts, or `never`.
  static Real parting(LinkSeries<Rotates> const& link, Real distance, Real until) {
    auto const overlap = [&](Real s) {
      return Gap{distance * distance - value(link.u, s), -rate(link.u, s)};
    };
    Real const left = distance * distance - link.u[0], opens = link.u[1];
    Real const bound = second_rate_bound(link.u, until);
    bool const stays = left - std::max<Real>(opens, 0) * until - bound * until * until / 2 > 0;
    return stays ? never : first_touch(overlap, 0, until, bound);
  }

  Material<Rotates> const* material_;
  ImageShifts const* shifts_;
  ClusterSeries<Rotates> series_;
};

}  // namespace bagnold::events
