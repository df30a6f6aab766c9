// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "kernels/cpu/events/cluster.hpp"
#include "kernels/cpu/events/image_shifts.hpp"
#include "kernels/cpu/events/link_series.hpp"
#include "kernels/cpu/events/material.hpp"

namespace bagnold::events {

/// Taylor series in time of the disks and contacts of one cluster, one order after the other.
template <bool Rotates>
class ClusterSeries {
 public:
  ClusterSeries(Material<Rotates> const& material, ImageShifts const& shifts)
      : material_(&material), shifts_(&shifts) {}

  /// Series of contact n of the cluster that was asked for last.
  LinkSeries<Rotates> const& operator[](std::size_t n) const { return series_[n]; }
  std::size_t size() const { return series_.size(); }

  /// All series of a cluster, from the begin of its members.
  void find(Cluster<Rotates>& cluster) {
    series_.resize(cluster.links.size());
    forces_.resize(cluster.members.size());
    for (auto& m : cluster.members) {
      m.x[0] = m.begin.position.x;
      m.y[0] = m.begin.position.y;
      m.x[1] = m.begin.motion.velocity.x;
      m.y[1] = m.begin.motion.velocity.y;
      if constexpr (Rotates) m.spin[0] = m.begin.motion.spin;
    }
    for (std::size_t k = 0; k < series_.size(); ++k) {
      auto const& link = cluster.links[k];
      series_[k].start(separation(cluster, link, cluster.members[link.a].begin.position,
                                  cluster.members[link.b].begin.position));
    }
    add_orders(cluster, std::make_integer_sequence<int, series_order - 1>{});
    for (std::size_t k = 0; k < series_.size(); ++k) {
      auto const& link = cluster.links[k];
      series_[k].template finish<series_order>(cluster.members[link.a], cluster.members[link.b]);
    }
  }

 private:
  Vec2<Real> separation(Cluster<Rotates> const& cluster, Link const& link, Vec2<Real> const& a,
                        Vec2<Real> const& b) const {
    return a - b - (*shifts_)(link.other).at(cluster.time);
  }

  template <int... orders>
  void add_orders(Cluster<Rotates>& cluster, std::integer_sequence<int, orders...>) {
    (add_order<orders>(cluster), ...);
  }

  /// Coefficients k + 2 of positions, k + 1 of spins.
  template <int k>
  void add_order(Cluster<Rotates>& cluster) {
    auto const& table = material_->table;
    for (auto& f : forces_) f = {};
    for (std::size_t n = 0; n < series_.size(); ++n) {
      auto const& link = cluster.links[n];
      auto& of = series_[n];
      auto const &a = cluster.members[link.a], &b = cluster.members[link.b];
      of.x[k + 1] = a.x[k + 1] - b.x[k + 1];
      of.y[k + 1] = a.y[k + 1] - b.y[k + 1];
      if constexpr (k == 0) of.x[1] -= (*shifts_)(link.other).velocity;
      Real const inverse_distance = inverse_class_distance(pair_class(a.species, b.species));
      LinkConstants const c{inverse_distance, material_->damping.normal,
                            material_->damping.tangential};
      auto &on_a = forces_[link.a], &on_b = forces_[link.b];
      if constexpr (Rotates) {
        auto const& d = table.diameter;
        of.turn[k] = (d[a.species] * a.spin[k] + d[b.species] * b.spin[k]) * (inverse_distance / 2);
      }
      auto const f = of.template force<k>(c);
      on_a.force += f;
      on_b.force += -1.0 * f;
      if constexpr (Rotates) {
        Real const torque = of.template torque_per_diameter<k>(c);
        on_a.torque += torque;
        on_b.torque += torque;
      }
    }
    for (std::size_t n = 0; n < forces_.size(); ++n) {
      auto& m = cluster.members[n];
      Real const share = table.inverse_mass[m.species] / ((k + 1) * (k + 2));
      m.x[k + 2] = share * forces_[n].force.x;
      m.y[k + 2] = share * forces_[n].force.y;
      if constexpr (Rotates)
        m.spin[k + 1] = table.inverse_inertia[m.species] * table.diameter[m.species] / (k + 1) *
                        forces_[n].torque;
    }
    if constexpr (Rotates && k == series_order - 2)
      for (auto& m : cluster.members) m.spin[series_order] = 0;
  }

  struct OnMember {
    Vec2<Real> force;
    Real torque = 0;  ///< over its diameter
  };

  Material<Rotates> const* material_;
  ImageShifts const* shifts_;
  std::vector<LinkSeries<Rotates>> series_;  ///< [links]
  std::vector<OnMember> forces_;             ///< [members]
};

}  // namespace bagnold::events
