// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/events/pair_touches.hpp"

#include <utility>

#include "kernels/cpu/events/first_touch.hpp"

namespace bagnold::events {

namespace {

/// True if two disks do not touch within a time: f = r^2 - d^2, and f'' is above -2 r |r''|, where
/// r is below 2 d. acceleration: bound of |r''|.
bool far_apart(Vec2<Real> const& r, Vec2<Real> const& v, Real d, Real acceleration, Real time) {
  Real const apart = dot(r, r) - d * d, closes = std::min<Real>(2 * dot(r, v), 0) * time;
  return apart + closes - 2 * d * acceleration * time * time > 0;
}

}  // namespace

template <bool Rotates>
LinePair PairTouches<Rotates>::lines(std::uint32_t i, Neighbor n) const {
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
bool PairTouches<Rotates>::stays_apart(Cluster<Rotates> const& cluster, Member<Rotates> const& m,
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

template <bool Rotates>
Real PairTouches<Rotates>::touch(std::uint32_t i, Neighbor n) const {
  auto const j = n.index();
  Path const &p = disks_->path[i], &q = disks_->path[j];
  if (disks_->touch_each_other(i, j)) return never;  // they part, and fly straight
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
  if (pair.from <= disks_->now) return pair.touch();  // before, they did not
  Real const time = gap_closes(i, n, std::max(p.begun, q.begun), pair.from);
  return time < never ? time : pair.touch();
}

template <bool Rotates>
Real PairTouches<Rotates>::gap_closes(std::uint32_t i, Neighbor n, Real from, Real until) const {
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
  Real const acceleration = disks_->acceleration(i, from) + disks_->acceleration(j, from);
  auto const [r, v] = pair(from);
  if (far_apart(r, v, d, acceleration, until - from)) return never;
  return first_touch(gap, from, until, acceleration);
}

template class PairTouches<false>;
template class PairTouches<true>;

}  // namespace bagnold::events
