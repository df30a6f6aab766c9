// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Core.hpp>
#include <vector>

#include "kernels/cpu/events/prefetch.hpp"
#include "kernels/device/neighbors/neighbor_search.hpp"
#include "kernels/physics/box/list_criterion.hpp"
#include "src/engine/blocks/block_loop.hpp"

namespace bagnold::events {

/// The neighbours that a disk may touch while it stays within `reach` of where the mean flow alone
/// would have taken it, up to a strain of `longest`.
class EventLists {
 public:
  using Space = Kokkos::Serial;

  explicit EventLists(Real skin);

  /// position: in the box, whose offset is in [0, L_x). each: over pieces of them, on threads, or
  /// none.
  void build(std::vector<Vec2<Real>> const& position, std::vector<Species> const& species,
             SpeciesTable const& table, ShearedBox const& box, BlockLoop* each);

  /// Takes the rows of some disks of the whole, ascending, among each other.
  void take(EventLists const& whole, std::vector<std::uint32_t> const& disks);

  /// Asks memory for all of them ahead.
  void fetch() const {
    prefetch_all(row_);
    prefetch_all(entries_);
  }

  std::uint32_t count() const { return static_cast<std::uint32_t>(row_.size()); }
  std::uint32_t begin(std::uint32_t i) const { return row_[i].begin; }
  std::uint32_t end(std::uint32_t i) const { return row_[i].end; }
  Neighbor entry(std::uint32_t k) const { return entries_[k]; }
  Neighbor const* entries() const { return entries_.data(); }

  Vec2<Real> const& at_build(std::uint32_t i) const { return row_[i].at_build; }
  Real skin() const { return skin_; }        ///< [d_s]
  Real reach() const { return reach_; }      ///< [d_s]
  Real longest() const { return longest_; }  ///< strain
  Real strain_rate() const { return box_.strain_rate; }
  ShearedBox const& box() const { return box_; }  ///< when it was built

  /// True if a disk on a line is within its reach at a time.
  bool within_reach(std::uint32_t i, Vec2<Real> const& place, Vec2<Real> const& velocity,
                    Real time) const {
    Vec2<Real> const& from = at_build(i);
    Real const x = place.x - from.x + time * (velocity.x - box_.strain_rate * from.y);
    Real const y = place.y - from.y + time * velocity.y;
    return x * x + y * y < reach_ * reach_;
  }

  /// When a disk on a line leaves its reach, in times since the build.
  Real leaves(std::uint32_t i, Vec2<Real> const& place, Vec2<Real> const& velocity) const;

 private:
  /// Row of a disk; half a cache line.
  struct alignas(32) Row {
    Vec2<Real> at_build;       ///< [d_s]
    std::uint32_t begin, end;  ///< in the entries
  };

  Real skin_, longest_, reach_;
  CellGridRoom<Space> room_;
  std::vector<Row> row_;  ///< [N]
  std::vector<Neighbor> entries_;
  std::vector<std::vector<Neighbor>> pieces_;  ///< of the entries, while they are found
  ShearedBox box_{};
};

}  // namespace bagnold::events
