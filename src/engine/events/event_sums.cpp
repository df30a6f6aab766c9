// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/events/event_sums.hpp"

namespace bagnold::events {

template <bool Rotates>
void EventSums<Rotates>::step(Cluster<Rotates> const& cluster, ClusterSteps<Rotates> const& steps,
                              Real until) {
  Real const from = std::max(cluster.time, begin_), time = until - from;
  if (!(time > 0)) return;
  constexpr Real node = 0.21132486540518711775;  // (1 - 1/sqrt(3))/2
  Real const s = from - cluster.time, half = time / 2 * inverse_step_;
  configuration(cluster, steps, s + node * time, half);
  configuration(cluster, steps, s + (1 - node) * time, half);
}

template <bool Rotates>
void EventSums<Rotates>::configuration(Cluster<Rotates> const& cluster,
                                       ClusterSteps<Rotates> const& steps, Real s, Real weight) {
  using C = SumColumns;
  auto const moving = [&](std::uint32_t a) { return cluster.members[a].at(s, cluster.step); };
  for (auto const& link : cluster.links) {
    auto const pair = steps.force(cluster, link, cluster.time + s, moving);
    add_pair(to_, pair, weight);
    Real turn = 0;
    auto const &a = cluster.members[link.a], &b = cluster.members[link.b];
    Real const inverse_distance = inverse_class_distance(pair_class(a.species, b.species));
    if constexpr (Rotates) {
      auto const& diameter = disks_->material.table.diameter;
      turn = diameter[a.species] * moving(link.a).motion.spin +
             diameter[b.species] * moving(link.b).motion.spin;
      to_[C::torque_power] += weight * turn * pair.torque_per_diameter(inverse_distance);
    }
    if (motion)
      motion->add(weight, pair.separation, steps.velocity(cluster, link, s),
                  turn * inverse_distance / 2);
  }
  for (auto const& m : cluster.members) {
    auto const of = m.at(s, cluster.step);
    struct Weighed {  // columns that take a share
      Real* to;
      Real weight;
      struct Column {
        Real& sum;
        Real weight;
        void operator+=(Real value) const { sum += weight * value; }
      };
      Column operator[](int c) const { return {to[c], weight}; }
    } const columns{to_, weight};
    add_motion(columns, disks_->mass(m.disk),
               peculiar_x(of.motion.velocity.x, of.position.y, strain_rate), of.motion.velocity.y);
    if constexpr (Rotates) add_spin(columns, of.motion.spin);
  }
}

template class EventSums<false>;
template class EventSums<true>;

}  // namespace bagnold::events
