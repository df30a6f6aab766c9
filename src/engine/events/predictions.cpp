// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/events/predictions.hpp"

#include "kernels/cpu/events/first_touch.hpp"

namespace bagnold::events {

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
  Path const& p = disks_->path[i];
  Real first = never;
  Event event{i, 0, 0, Event::Kind::leave};
  if (watch_reach) first = lists_->leaves(i, p.place, p.velocity);
  for (auto k = lists_->begin(i); k < lists_->end(i); ++k) {
    Neighbor const n = lists_->entry(k);
    Path const& q = disks_->path[n.index()];
    auto const pair = lines(i, n);
    bool const near =
        pair.may_touch_before(p.deviation + q.deviation, pair.from - std::max(p.begun, q.begun));
    Real const time = near ? touch(i, n, pair) : pair.touch();
    if (!(time < first)) continue;
    if (q.manner == Manner::cluster && time > q.straight) continue;
    first = time;
    event = {i, k, q.changes, Event::Kind::touch};
  }
  queue_->set(i, first, event);
}

template <bool Rotates>
void Predictions<Rotates>::of_cluster(std::uint32_t k) {
  auto const& cluster = disks_->clusters[k];
  Real first = cluster.end();
  Event event{cluster.slot(), 0, 0, Event::Kind::end};
  for (std::uint32_t a = 0; a < cluster.members.size(); ++a) {
    auto const i = cluster.members[a].disk;
    Path const& p = disks_->path[i];
    for (auto e = lists_->begin(i); e < lists_->end(i); ++e) {
      Neighbor const n = lists_->entry(e);
      auto const j = n.index();
      Path const& q = disks_->path[j];
      bool const mate = q.manner == Manner::cluster && disks_->touching[j] == k;
      if (mate && (j < i || cluster.linked(a, disks_->member[j]))) continue;
      auto const pair = lines(i, n);
      if (!pair.may_touch_before(p.deviation + q.deviation, pair.from - std::max(p.begun, q.begun)))
        continue;
      Real const time = touch(i, n, pair);
      if (!(time < first)) continue;
      first = time;
      event = {i, e, q.changes, Event::Kind::touch};
    }
  }
  queue_->set(cluster.slot(), first, event);
}

/// Of two that may touch before both are on their lines.
template <bool Rotates>
Real Predictions<Rotates>::touch(std::uint32_t i, Neighbor n, LinePair const& pair) const {
  auto const j = n.index();
  Path const &p = disks_->path[i], &q = disks_->path[j];
  if (p.manner == Manner::contact && q.manner == Manner::contact &&
      disks_->touching[i] == disks_->touching[j])
    return never;  // they part, and fly straight
  Real const begun = std::max(p.begun, q.begun);
  Real until = pair.from;
  bool const stepped = p.manner == Manner::cluster || q.manner == Manner::cluster;
  if (stepped)
    until = std::min(p.manner == Manner::cluster ? p.straight : never,
                     q.manner == Manner::cluster ? q.straight : never);
  if (begun < until) {
    Real const d = disks_->distance(i, n);
    auto const& shift = disks_->shifts(n);
    auto const gap = [&](Real t) {  // to the last bit the same for j and i
      auto const a = disks_->at(i, t), b = disks_->at(j, t);
      auto const r = (a.position - b.position) - shift.at(t);
      auto const v = (a.motion.velocity - b.motion.velocity) - Vec2<Real>{shift.velocity, 0};
      Real const width = std::sqrt(dot(r, r));
      return Gap{width - d, dot(r, v) / width};
    };
    Real const time =
        first_touch(gap, begun, until, disks_->acceleration(i) + disks_->acceleration(j));
    if (time < never) return time;
  }
  return stepped ? never : pair.touch();
}

template class Predictions<false>;
template class Predictions<true>;

}  // namespace bagnold::events
