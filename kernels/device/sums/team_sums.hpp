// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/device/sums/measure.hpp"
#include "kernels/device/team.hpp"

namespace bagnold {

/// The sums of one system by a team: a disk a thread, then added column by column in the order of
/// MeasureBlock, so the bits are the same.
template <class Forces, class Space>
struct TeamSums {
  using Row = Kokkos::View<Sums<Forces::rotates>*, Space>;

  Forces forces;
  Row of_disk;   ///< [N], for the team's use
  Row of_block;  ///< [ceil(N / measured_block)], likewise

  template <class Team>
  KOKKOS_FUNCTION void operator()(Team const& members, Sums<Forces::rotates>& total) const {
    constexpr std::int32_t columns = Sums<Forces::rotates>::columns;
    auto const count = static_cast<std::int32_t>(of_disk.extent(0));
    auto const blocks = static_cast<std::int32_t>(of_block.extent(0));
    team::for_all(members, count, [this](std::int32_t i) {
      of_disk(i) = MeasureDisk<Forces>{forces}(static_cast<std::uint32_t>(i));
    });
    team::for_all(members, blocks * columns, [&](std::int32_t k) {
      std::int32_t const block = k / columns, column = k % columns;
      std::int32_t const begin = block * static_cast<std::int32_t>(measured_block);
      std::int32_t const full = begin + static_cast<std::int32_t>(measured_block);
      Real sum = 0;
      for (auto i = begin; i < (full < count ? full : count); ++i) sum += of_disk(i).value[column];
      of_block(block).value[column] = sum;
    });
    team::for_all(members, columns, [&](std::int32_t column) {
      Real sum = 0;
      for (std::int32_t block = 0; block < blocks; ++block) sum += of_block(block).value[column];
      total.value[column] = sum;
    });
  }
};

}  // namespace bagnold
