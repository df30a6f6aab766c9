// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/blocks/pair_islands.hpp"

#include <cmath>

namespace bagnold {

namespace {

constexpr std::uint32_t lanes = simd::width;

BinaryDisk disk_of(BlockSystem const& all, ShearedBox const& box, Islands::Disk const& disk) {
  Real const spin = all.rotates ? all.now.spin(disk.slot) : 0;
  return {at_image(all.now.record(disk.slot), disk.image, box), spin, all.species(disk.slot), 0};
}

void keep(MeetingResults& results, std::uint32_t slot, BinaryDisk const& disk) {
  auto& result = results.of(slot);
  result.record = disk.record;
  result.spin = disk.spin;
  result.deviation = std::sqrt(disk.stray2);
}

}  // namespace

bool PairIslands::run(BlockDisks const& disks, Islands const& islands, LookaheadWindow& window,
                      WindowScratch& scratch) {
  auto const count = static_cast<std::uint32_t>(pairs.size());
  if (count == 0) return true;
  auto const& all = disks.system;
  auto& results = scratch.results;
  auto const first_unit = results.units.size();
  for (auto const& pair : pairs) {
    scratch.add_unit(false);
    results.add_pair(islands, pair);
    results.add_disk(islands.disks[pair.a]);
    results.add_disk(islands.disks[pair.b]);
  }
  auto const lane_watch = [&](std::uint32_t begin, std::uint32_t end) {
    LaneWatch watch;
    for (auto i = begin; i < end; ++i)
      scratch.contacts.set_lane(all, watch, static_cast<int>(i - begin), first_unit + i,
                                islands.disks[pairs[i].a].slot, islands.disks[pairs[i].b].slot);
    return watch;
  };
  auto const groups = (count + lanes - 1) / lanes;
  outcome_.assign(groups, {});
  (*disks.loop)(groups, [&](std::uint32_t g) {
    BinaryDisk a[lanes], b[lanes];
    auto const begin = g * lanes, end = std::min(begin + lanes, count);
    for (auto i = begin; i < end; ++i) {
      a[i - begin] = disk_of(all, scratch.start, islands.disks[pairs[i].a]);
      b[i - begin] = disk_of(all, scratch.start, islands.disks[pairs[i].b]);
    }
    auto* const sums = results.sums.data() + results.units[first_unit + begin].sums;
    auto const collide = [&](LaneWatch* watch) {
      outcome_[g] = disks.stepper->collide(a, b, static_cast<int>(end - begin), window.steps(),
                                           disks.clock.strain_rate, scratch.times, sums, watch);
    };
    if (scratch.contacts) {
      auto watch = lane_watch(begin, end);
      collide(&watch);
    } else {
      collide(nullptr);
    }
    for (auto i = begin; i < end; ++i) {
      keep(results, islands.disks[pairs[i].a].slot, a[i - begin]);
      keep(results, islands.disks[pairs[i].b].slot, b[i - begin]);
    }
  });
  for (auto const& outcome : outcome_) {
    if (outcome.bad) return false;
    window.contacts += static_cast<Real>(outcome.touching) / static_cast<Real>(window.steps());
    window.work.binary_steps += static_cast<Real>(outcome.steps);
  }
  window.work.binary += count;
  return true;
}

}  // namespace bagnold
