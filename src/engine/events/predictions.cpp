// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/events/predictions.hpp"

#include <bit>
#include <utility>

#include "kernels/cpu/events/first_touch.hpp"
#include "kernels/cpu/events/pack_touches.hpp"

namespace bagnold::events {

namespace {

PackTouches pack_of(Path const& p) {
  Real const small = class_distance(pair_class(p.species, 0)),
             big = class_distance(pair_class(p.species, 1));
  return {p, small * small, big * big};
}

/// Whether two disks do not touch within a time: f = r^2 - d^2, and f'' is above -2 r |r''|, where
/// r is below 2 d. acceleration: bound of |r''|.
bool far_apart(Vec2<Real> const& r, Vec2<Real> const& v, Real d, Real acceleration, Real time) {
  Real const apart = dot(r, r) - d * d, closes = std::min<Real>(2 * dot(r, v), 0) * time;
  return apart + closes - 2 * d * acceleration * time * time > 0;
}

}  // namespace

template <bool Rotates>
LinePair Predictions<Rotates>::lines(std::uint32_t i, Neighbor n) const {
  Path const &p = disks_->path[i], &q = disks_->path[n.index()];
  auto const& shift = disks_->shifts(n);
  LinePair pair;
  pair.from = std::max(p.straight, q.straight);
  pair.velocity = {p.velocity.x - q.velocity.x - shift.velocity, p.velocity.y - q.velocity.y};
  pair.separation = {p.place.x - q.place.x - shift.place.x + pair.velocity.x * pair.from,
                     p.place.y - q.place.y - shift.place.y + pair.velocity.y * pair.from};
  Real const d = disks_->distance(i, n);
  pair.approach = dot(pair.separation, pair.velocity);
  pair.beyond = dot(pair.separation, pair.separation) - d * d;
  pair.velocity2 = dot(pair.velocity, pair.velocity);
  return pair;
}

template <bool Rotates>
void Predictions<Rotates>::of_disk(std::uint32_t i) {
  auto const* const paths = disks_->path.data();
  Path const& p = paths[i];
  auto pack = pack_of(p);
  Real first = never;
  Event event{i, 0, 0, Event::Kind::leave};
  auto const end = lists_->end(i);
  for (auto k = lists_->begin(i); k < end; k += simd::width) {
    auto const* const neighbors = lists_->entries() + k;
    pack.find(paths, disks_->shifts, neighbors, std::min<std::uint32_t>(simd::width, end - k));
    for (unsigned left = pack.near | pack.touching; left != 0; left &= left - 1) {
      auto const lane = static_cast<unsigned>(std::countr_zero(left));
      Neighbor const n = neighbors[lane];
      Path const& q = paths[n.index()];
      bool const near = (pack.near >> lane & 1u) != 0, stepped = q.manner == Manner::cluster;
      if (stepped && !near) continue;
      if (stepped) near_.add_seen_from(*disks_, *lists_, i, n);
      Real const time = near ? touch(i, n) : pack.time[lane];
      if (!(time < first)) continue;
      first = time;
      event = {i, k + lane, q.changes, Event::Kind::touch};
    }
  }
  if (watch_reach && !lists_->within_reach(i, p.place, p.velocity, first))
    if (Real const leaves = lists_->leaves(i, p.place, p.velocity); leaves < first) {
      first = leaves;
      event = {i, 0, 0, Event::Kind::leave};
    }
  queue_->set(i, first, event);
}

template <bool Rotates>
void Predictions<Rotates>::find_near(std::uint32_t i) {
  auto const* const paths = disks_->path.data();
  auto pack = pack_of(paths[i]);
  near_.clear(i);
  auto const begin = lists_->begin(i), end = lists_->end(i);
  for (auto k = begin; k < end; k += simd::width) {
    auto const* const neighbors = lists_->entries() + k;
    pack.find(paths, disks_->shifts, neighbors, std::min<std::uint32_t>(simd::width, end - k));
    for (unsigned left = pack.near; left != 0; left &= left - 1) {
      auto const lane = static_cast<unsigned>(std::countr_zero(left));
      Neighbor const n = neighbors[lane];
      near_.add(i, k + lane - begin);
      if (paths[n.index()].manner == Manner::cluster) near_.add_seen_from(*disks_, *lists_, i, n);
    }
  }
}

template <bool Rotates>
void Predictions<Rotates>::of_cluster(std::uint32_t k) {
  auto const* const paths = disks_->path.data();
  auto const& cluster = disks_->clusters[k];
  Real first = cluster.end();
  Event event{cluster.slot(), 0, 0, Event::Kind::end};
  for (auto const& m : cluster.members)
    if (m.strays) find_near(m.disk);
  for (std::uint32_t a = 0; a < cluster.members.size(); ++a) {
    auto const i = cluster.members[a].disk;
    auto const begin = lists_->begin(i);
    near_.for_each(i, lists_->end(i) - begin, [&](std::uint32_t e) {
      Neighbor const n = lists_->entry(begin + e);
      auto const j = n.index();
      bool const mate = paths[j].manner == Manner::cluster && disks_->touching[j] == k;
      if (mate && (j < i || cluster.linked(a, disks_->member[j]))) return;
      if (stays_apart(cluster, cluster.members[a], n, mate)) return;
      Real const time = touch(i, n);
      if (!(time < first)) return;
      first = time;
      event = {i, begin + e, paths[j].changes, Event::Kind::touch};
    });
  }
  queue_->set(cluster.slot(), first, event);
}

/// Whether a disk of a cluster and a mate, or one that flies, cannot touch in its step.
template <bool Rotates>
bool Predictions<Rotates>::stays_apart(Cluster<Rotates> const& cluster, Member<Rotates> const& m,
                                       Neighbor n, bool mate) const {
  Path const& q = disks_->path[n.index()];
  Real const time = cluster.time;
  Vec2<Real> place = q.at(time), velocity = q.velocity;
  Real acceleration = m.acceleration;
  if (mate) {
    auto const& other = cluster.members[disks_->member[n.index()]];
    place = other.begin.position;
    velocity = other.begin.motion.velocity;
    acceleration += other.acceleration;
  } else if (q.manner == Manner::cluster || time < q.straight) {
    return false;
  }
  auto const& shift = disks_->shifts(n);
  auto const r = m.begin.position - place - shift.at(time);
  auto const v = m.begin.motion.velocity - velocity - Vec2<Real>{shift.velocity, 0};
  return far_apart(r, v, disks_->distance(m.disk, n), acceleration, cluster.step);
}

/// Of two that may touch before both are on their lines. A disk of a cluster has a path to the end
/// of its step.
template <bool Rotates>
Real Predictions<Rotates>::touch(std::uint32_t i, Neighbor n) const {
  auto const j = n.index();
  Path const &p = disks_->path[i], &q = disks_->path[j];
  if (p.manner == Manner::contact && q.manner == Manner::contact &&
      disks_->touching[i] == disks_->touching[j])
    return never;  // they part, and fly straight
  bool const first_steps = p.manner == Manner::cluster, second_steps = q.manner == Manner::cluster;
  if (first_steps || second_steps) {
    Real from = -never, until = never;
    for (auto const disk : {i, j}) {
      Path const& path = disks_->path[disk];
      if (path.manner != Manner::cluster) {
        from = std::max(from, path.begun);
        continue;
      }
      auto const& cluster = disks_->clusters[disks_->touching[disk]];
      from = std::max(from, cluster.time);
      until = std::min(until, cluster.end());
    }
    return gap_closes(i, n, from, until);
  }
  auto const pair = lines(i, n);
  Real const time = gap_closes(i, n, std::max(p.begun, q.begun), pair.from);
  return time < never ? time : pair.touch();
}

template <bool Rotates>
Real Predictions<Rotates>::gap_closes(std::uint32_t i, Neighbor n, Real from, Real until) const {
  if (!(from < until)) return never;
  auto const j = n.index();
  Real const d = disks_->distance(i, n);
  auto const& shift = disks_->shifts(n);
  auto const pair = [&](Real t) {  // to the last bit the same for j and i
    auto const a = disks_->at(i, t), b = disks_->at(j, t);
    return std::pair((a.position - b.position) - shift.at(t),
                     (a.motion.velocity - b.motion.velocity) - Vec2<Real>{shift.velocity, 0});
  };
  auto const gap = [&](Real t) {
    auto const [r, v] = pair(t);
    Real const width = std::sqrt(dot(r, r));
    return Gap{width - d, dot(r, v) / width};
  };
  Real const acceleration = disks_->acceleration(i) + disks_->acceleration(j);
  auto const [r, v] = pair(from);
  if (far_apart(r, v, d, acceleration, until - from)) return never;
  return first_touch(gap, from, until, acceleration);
}

template class Predictions<false>;
template class Predictions<true>;

}  // namespace bagnold::events
