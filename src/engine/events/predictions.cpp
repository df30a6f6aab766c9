// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/events/predictions.hpp"

#include <bit>

#include "kernels/cpu/events/first_touch.hpp"
#include "kernels/cpu/events/pack_touches.hpp"

namespace bagnold::events {

namespace {

PackTouches pack_of(Path const& p) {
  Real const small = class_distance(pair_class(p.species, 0)),
             big = class_distance(pair_class(p.species, 1));
  return {p, small * small, big * big};
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
      bool const near = (pack.near >> lane & 1u) != 0;
      Real const time = near ? touch(i, n, lines(i, n)) : pack.time[lane];
      if (!(time < first) || (q.manner == Manner::cluster && time > q.straight)) continue;
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
void Predictions<Rotates>::of_cluster(std::uint32_t k) {
  auto const* const paths = disks_->path.data();
  auto const& cluster = disks_->clusters[k];
  Real first = cluster.end();
  Event event{cluster.slot(), 0, 0, Event::Kind::end};
  for (std::uint32_t a = 0; a < cluster.members.size(); ++a) {
    auto const i = cluster.members[a].disk;
    auto pack = pack_of(paths[i]);
    auto const end = lists_->end(i);
    for (auto e = lists_->begin(i); e < end; e += simd::width) {
      auto const* const neighbors = lists_->entries() + e;
      pack.find(paths, disks_->shifts, neighbors, std::min<std::uint32_t>(simd::width, end - e));
      for (unsigned left = pack.near; left != 0; left &= left - 1) {
        auto const lane = static_cast<unsigned>(std::countr_zero(left));
        Neighbor const n = neighbors[lane];
        auto const j = n.index();
        bool const mate = paths[j].manner == Manner::cluster && disks_->touching[j] == k;
        if (mate && (j < i || cluster.linked(a, disks_->member[j]))) continue;
        Real const time = touch(i, n, lines(i, n));
        if (!(time < first)) continue;
        first = time;
        event = {i, e + lane, paths[j].changes, Event::Kind::touch};
      }
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
