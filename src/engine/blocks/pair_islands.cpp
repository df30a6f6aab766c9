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
  result.deviation = std::sqrt(disk.flight_deviation2);
}

}  // namespace

bool PairIslands::run(BlockDisks const& disks, Islands const& islands, Lookahead& lookahead,
                      LookaheadScratch& scratch) {
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
  auto const detector_of = [&](std::uint32_t begin, std::uint32_t end) {
    LaneDetector detector;
    for (auto i = begin; i < end; ++i)
      scratch.contacts.set_lane(all, detector, static_cast<int>(i - begin), first_unit + i,
                                islands.disks[pairs[i].a].slot, islands.disks[pairs[i].b].slot);
    return detector;
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
    auto const collide = [&](LaneDetector* detector) {
      outcome_[g] = disks.stepper->lone_pairs->collide(
          a, b, static_cast<int>(end - begin), lookahead.steps(), disks.clock.strain_rate,
          scratch.flights, scratch.times, sums, detector);
    };
    if (scratch.contacts) {
      auto detector = detector_of(begin, end);
      collide(&detector);
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
    lookahead.contacts +=
        static_cast<Real>(outcome.touching) / static_cast<Real>(lookahead.steps());
    lookahead.work.binary_steps += static_cast<Real>(outcome.steps);
  }
  lookahead.work.binary += count;
  return true;
}

}  // namespace bagnold
