// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/events/event_lists.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "src/engine/compiled_once.hpp"
#include "src/engine/device_copy.hpp"

namespace bagnold::events {

namespace {

constexpr Real share_of_strain = 0.3;  // of the skin that the shear alone may use up
constexpr std::uint32_t piece = 4096;  // disks whose lists one thread builds
constexpr Real margin = 0.96;          // of the reach: disks fly on to the end of a step

}  // namespace

EventLists::EventLists(Real skin)
    : skin_(skin),
      longest_(share_of_strain * 2 * skin / (big_diameter + skin)),
      reach_(margin * list_reach(longest_, skin)) {}

void EventLists::build(std::vector<Vec2<Real>> const& position, std::vector<Species> const& species,
                       SpeciesTable const& table, ShearedBox const& box, BlockLoop* each) {
  box_ = box;
  auto const places = to_device<Space>("events::at_build", position);
  auto const grid = make_cell_grid_in(room_, Space{}, places, box, big_diameter + skin_, {});
  NeighborSearch<Space> const search{
      places, to_device<Space>("events::species", species), grid, table, box, skin_};
  auto const count = static_cast<std::uint32_t>(position.size());
  row_.resize(count);
  auto const find = [&](std::uint32_t first, std::uint32_t last, std::vector<Neighbor>& entries) {
    entries.clear();
    for (auto i = first; i < last; ++i) {
      auto const begin = static_cast<std::uint32_t>(entries.size());
      search(i, [&](Neighbor const& n) { entries.push_back(n); });
      row_[i] = {position[i], begin, static_cast<std::uint32_t>(entries.size())};
    }
  };
  if (!each) return find(0, count, entries_);
  auto const pieces = (count + piece - 1) / piece;
  pieces_.resize(pieces);
  auto const end_of = [&](std::uint32_t p) { return std::min((p + 1) * piece, count); };
  (*each)(pieces, [&](std::uint32_t p) { find(p * piece, end_of(p), pieces_[p]); });
  std::vector<std::uint32_t> before{0};
  for (auto const& entries : pieces_)
    before.push_back(before.back() + static_cast<std::uint32_t>(entries.size()));
  entries_.resize(before.back());
  (*each)(pieces, [&](std::uint32_t p) {
    std::ranges::copy(pieces_[p], entries_.begin() + before[p]);
    for (auto i = p * piece; i < end_of(p); ++i) {
      row_[i].begin += before[p];
      row_[i].end += before[p];
    }
  });
}

void EventLists::take(EventLists const& whole, std::vector<std::uint32_t> const& disks) {
  constexpr auto none = Neighbor::max_count;
  thread_local std::vector<std::uint32_t> places;  // none outside of here
  places.resize(whole.count(), none);
  for (std::uint32_t k = 0; k < disks.size(); ++k) places[disks[k]] = k;
  box_ = whole.box_;
  entries_.clear();
  row_.clear();
  for (auto const i : disks) {
    auto const begin = static_cast<std::uint32_t>(entries_.size());
    for (auto e = whole.begin(i); e < whole.end(i); ++e) {
      Neighbor const n = whole.entry(e);
      if (auto const k = places[n.index()]; k != none)
        entries_.push_back(Neighbor::make(k, n.image(), n.big()));
    }
    row_.push_back({whole.at_build(i), begin, static_cast<std::uint32_t>(entries_.size())});
  }
  for (auto const i : disks) places[i] = none;
}

Real EventLists::leaves(std::uint32_t i, Vec2<Real> const& place,
                        Vec2<Real> const& velocity) const {
  auto const w = place - at_build(i);
  Vec2<Real> const u{velocity.x - box_.strain_rate * at_build(i).y, velocity.y};
  Real const a = dot(u, u), b = dot(w, u), c = dot(w, w) - reach_ * reach_;
  if (a == 0) return std::numeric_limits<Real>::infinity();
  Real const discriminant = b * b - a * c;
  return discriminant <= 0 ? 0 : (std::sqrt(discriminant) - b) / a;
}

}  // namespace bagnold::events
