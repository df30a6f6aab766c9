// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Core.hpp>

#include "kernels/device/sums/measure.hpp"

namespace bagnold {

/// Sums that are added in their order to one; groups of such sums are added in order afterwards,
/// and so on. So a total does not depend on threads.
inline constexpr std::int64_t added_together = 64;

constexpr std::int64_t groups_of_sums(std::int64_t count) {
  return (count + added_together - 1) / added_together;
}

/// One column of one group: index k = group * columns + column.
template <class Columns, class Space>
struct AddGroup {
  using Row = Kokkos::View<Columns*, Space>;
  static constexpr std::int64_t columns = Columns::columns;

  Row from;
  std::int64_t count;  ///< of sums in `from`
  Row to;
  std::int64_t first = 0;  ///< place of the first group in `to`

  KOKKOS_FUNCTION void operator()(std::int64_t k) const {
    std::int64_t const group = k / columns, column = k % columns;
    std::int64_t const begin = group * added_together, full = begin + added_together;
    Real sum = 0;
    for (auto i = begin; i < (full < count ? full : count); ++i) sum += from(i).value[column];
    to(first + group).value[column] = sum;
  }
};

/// Adds the sums of disks, in the order of `of_disk`, and puts the total at totals(place). of_disk
/// and of_group, [groups_of_sums(N)], are worked with.
template <class Loops, class Columns, class Space>
KOKKOS_FUNCTION void add_groups(Loops const& loops, Kokkos::View<Columns*, Space> const& of_disk,
                                Kokkos::View<Columns*, Space> const& of_group,
                                Kokkos::View<Columns*, Space> const& totals, std::int64_t place) {
  using Group = AddGroup<Columns, Space>;
  auto count = static_cast<std::int64_t>(of_disk.extent(0));
  auto from = of_disk, to = of_group;
  while (count > added_together) {
    auto const groups = groups_of_sums(count);
    loops.for_all("sums::AddGroups", groups * Group::columns, Group{from, count, to});
    auto const added = to;
    to = from;
    from = added;
    count = groups;
  }
  loops.for_all("sums::AddLastGroup", Group::columns, Group{from, count, totals, place});
}

/// The sums of a configuration: a disk a thread, then group by group, by launches or in a team.
template <class Forces, class Space>
struct AddUp {
  static constexpr bool rotates = Forces::rotates;
  using Row = Kokkos::View<Sums<rotates>*, Space>;

  Forces forces;
  Row of_disk;                               ///< [N], to work with
  Row of_group;                              ///< [groups_of_sums(N)], likewise
  Kokkos::View<std::uint32_t*, Space> rank;  ///< [N], the order of the disks; empty: by index

  /// Puts the total at totals(place).
  template <class Loops>
  KOKKOS_FUNCTION void operator()(Loops const& loops, Row const& totals, std::int64_t place) const {
    loops.for_all("sums::MeasureDisks", static_cast<std::int64_t>(of_disk.extent(0)),
                  MeasureDisks<Forces, Space>{forces, of_disk, rank});
    add_groups(loops, of_disk, of_group, totals, place);
  }
};

}  // namespace bagnold
