// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/events/predictions.hpp"

#include <bit>

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
void Predictions<Rotates>::of_disk(std::uint32_t i, bool watched) {
  auto const* const paths = disks_->path.data();
  Path const& p = paths[i];
  auto pack = pack_of(p);
  Real first = never;
  Event event{i, {}, 0, Event::Kind::leave};
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
      Real const time = near ? pairs_.touch(i, n) : pack.time[lane];
      if (!(time < first)) continue;
      first = time;
      event = {i, n, q.changes, Event::Kind::touch};
    }
  }
  if (watched && !lists_->within_reach(i, p.place, p.velocity, first))
    if (Real const leaves = lists_->leaves(i, p.place, p.velocity); leaves < first) {
      first = leaves;
      event = {i, {}, 0, Event::Kind::leave};
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
  Event event{cluster.slot(), {}, 0, Event::Kind::end};
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
      if (pairs_.stays_apart(cluster, cluster.members[a], n, mate)) return;
      Real const time = pairs_.touch(i, n);
      if (!(time < first)) return;
      first = time;
      event = {i, n, paths[j].changes, Event::Kind::touch};
    });
  }
  queue_->set(cluster.slot(), first, event);
}

template class Predictions<false>;
template class Predictions<true>;

}  // namespace bagnold::events
