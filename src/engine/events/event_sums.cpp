// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/events/event_sums.hpp"

#include <algorithm>

#include "kernels/cpu/events/node_roots.hpp"
#include "kernels/physics/repulsion/repulsion.hpp"

namespace bagnold::events {

namespace {

/// Columns at the nodes, of all that is in a cluster.
struct NodeColumns {
  AtNodes value[SumColumns::count_rotating];
  AtNodes& operator[](int column) { return value[column]; }
};

}  // namespace

/// Units of the columns in a time that goes `speed` times as fast; masses make up for it in forces,
/// energies and kinetic stresses.
template <bool Rotates>
void EventSums<Rotates>::set_speed(Real speed) {
  using C = SumColumns;
  speed_ = speed;
  for (auto& unit : unit_) unit = 1;
  unit_[C::velocity_x2] = unit_[C::velocity_y2] = unit_[C::spin2] = speed * speed;
  unit_[C::dissipation] = unit_[C::spin] = unit_[C::torque_power] = speed;
  for (int c = 0; c < ContactMotion::count; ++c)
    unit_of_motion_[c] = c < ContactMotion::tangential ? speed * speed : speed;
  unit_of_motion_[ContactMotion::contacts] = 1;
}

template <bool Rotates>
void EventSums<Rotates>::step(Cluster<Rotates> const& cluster, Real until) {
  Real const from = std::max(cluster.time, begin_);
  if (!(until > from) || !open_) return;
  Real const half = (until - from) / 2, weight = half * inverse_step_ / speed_;
  AtNodes const s = AtNodes(from - cluster.time + half) + AtNodes(half) * AtNodes::abscissas();
  nodes_.clear();
  for (auto const& m : cluster.members) {
    auto& of = nodes_.emplace_back();
    of.position = m.position(s);
    of.velocity = m.velocity(s);
    if constexpr (Rotates) of.spin = value(m.spin, s);
  }
  auto const& members = cluster.members;
  for (auto m = members.begin(); m != members.end(); ++m) {
    Real* const to = sums_of(m->disk);
    bool const added = std::any_of(members.begin(), m,
                                   [&](auto const& before) { return sums_of(before.disk) == to; });
    if (to && !added) add_members(to, cluster, AtNodes(cluster.time) + s, weight);
  }
}

/// All that is added to the same columns.
template <bool Rotates>
void EventSums<Rotates>::add_members(Real* columns, Cluster<Rotates> const& cluster,
                                     AtNodes const& time, Real weight) {
  NodeColumns sums;
  for (auto& c : sums.value) c = AtNodes(0.0);
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    auto const disk = cluster.members[k].disk;
    if (sums_of(disk) != columns) continue;
    auto const& of = nodes_[k];
    add_motion(sums, AtNodes(disks_->mass(disk)),
               peculiar_x(of.velocity.x, of.position.y, strain_rate), of.velocity.y);
    if constexpr (Rotates) add_spin(sums, of.spin);
  }
  in_units(columns, [&](Real* to, ContactMotion* of_motion) {
    int links = 0;
    for (auto const& link : cluster.links) {
      if (sums_of(cluster.members[link.a].disk) != columns) continue;
      add(sums.value, cluster, link, time, weight, of_motion);
      ++links;
    }
    for (int c = 0; c < Sums<Rotates>::columns; ++c)
      if (c != SumColumns::contacts) to[c] += weight * sums[c].integral();
    to[SumColumns::contacts] += 4 * weight * static_cast<Real>(links);
  });
}

/// A contact of a cluster.
template <bool Rotates>
void EventSums<Rotates>::add(AtNodes* columns, Cluster<Rotates> const& cluster, Link const& link,
                             AtNodes const& time, Real weight, ContactMotion* of_motion) {
  using C = SumColumns;
  auto const &a = nodes_[link.a], &b = nodes_[link.b];
  auto const &i = cluster.members[link.a], &j = cluster.members[link.b];
  auto const& shift = disks_->shifts(link.other);
  Vec2<AtNodes> const away{AtNodes(shift.place.x) + AtNodes(shift.velocity) * time,
                           AtNodes(shift.place.y)};
  auto const r = a.position - b.position - away;
  auto const v = a.velocity - b.velocity - Vec2<AtNodes>{AtNodes(shift.velocity), AtNodes(0.0)};
  Real const inverse_distance = inverse_class_distance(pair_class(i.species, j.species));
  AtNodes spins(0.0);
  if constexpr (Rotates) {
    auto const& diameter = disks_->material.table.diameter;
    spins = AtNodes(diameter[i.species]) * a.spin + AtNodes(diameter[j.species]) * b.spin;
  }
  auto const pair = pair_force(disks_->material.damping, HarmonicRepulsion{}, r, dot(r, r), v,
                               AtNodes(inverse_distance), spins);
  auto const of = columns_of(pair);
  for (int c = 0; c < pair_columns; ++c) columns[c] += of.value[c];
  if constexpr (Rotates)
    columns[C::torque_power] += spins * pair.torque_per_diameter(AtNodes(inverse_distance));
  if (!of_motion) return;
  auto const& share = AtNodes::weights().v;
  for (int k = 0; k < AtNodes::count; ++k)
    of_motion->add(weight * share[k], {r.x.v[k], r.y.v[k]}, {v.x.v[k], v.y.v[k]},
                   spins.v[k] * inverse_distance / 2);
}

template class EventSums<false>;
template class EventSums<true>;

}  // namespace bagnold::events
