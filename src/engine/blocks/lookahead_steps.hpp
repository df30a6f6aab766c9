// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cpu/islands/free_flight.hpp"
#include "kernels/cpu/islands/predict_contacts.hpp"
#include "src/engine/blocks/batch_islands.hpp"
#include "src/engine/blocks/block_disks.hpp"
#include "src/engine/blocks/forecast_list.hpp"
#include "src/engine/blocks/lookahead.hpp"
#include "src/engine/blocks/pair_islands.hpp"
#include "src/engine/sampling.hpp"

namespace bagnold {

/// Step of a scheme where most disks fly straight: a lookahead of many steps at a time.
///
/// From straight flights it predicts which disks meet within the lookahead. It steps only these,
/// island by island, and moves all others at once: for a disk that touches nothing the scheme is x
/// += v dt. A disk that meets another deviates from its straight flight, by a distance that is
/// measured at every step. Pairs that were not predicted and could have touched because of it are
/// added, and their islands are done again, until there are none.
class LookaheadSteps {
 public:
  /// Counts of the work of lookaheads. None is a time, so they are the same on every machine.
  struct Counters {
    std::int64_t lookaheads = 0, steps = 0;
    std::int64_t again = 0;         ///< pairs found to have been missed, and added
    std::int64_t binary = 0;        ///< islands of two disks
    std::int64_t binary_steps = 0;  ///< of a pair
    std::int64_t others = 0;        ///< disks in larger islands, repetitions included
    std::int64_t touching = 0;      ///< pairs, summed over steps
  };

  Counters counters;
  Real allowance = 0;     ///< deviations that near pairs cover, [d_s]; 0: not known yet
  Real usual = 0;         ///< deviation that one disk in a hundred exceeds, [d_s]
  bool cautious = false;  ///< near pairs of disks that meet others are stepped from the first

  /// skin: of the outer list, [d_s].
  LookaheadSteps(BlockDisks& disks, ContactDetector& detector, Real skin)
      : disks_(disks), detector_(detector), list_(disks, skin) {}

  /// Sets the flight times for the next lookahead, from here to `end`. Returns its duration at the
  /// rate at which it begins, [tau_e].
  Real time_flights(std::int64_t end);

  /// Does the lookahead and adds its sampled configurations to `windows`. Returns false, with
  /// nothing changed, if more than the share `most_active` of the disks take part, a disk goes too
  /// far for the list, a number is NaN or an overlap too large. The steps are then to be done one
  /// by one.
  bool run(Lookahead& lookahead, Sampling const& sampling, OpenWindows& windows, Real most_active);

 private:
  void make_room();
  void list_samples(Lookahead const& lookahead, Sampling const& sampling);
  void predict(Real duration);
  void add_near();
  void sort_islands();
  void find_missed(Real duration);
  void add_if_missed(SlotPair const& pair, Real duration);
  void take_unit_of(std::uint32_t slot);
  void measure(Lookahead const& lookahead, Sampling const& sampling, OpenWindows& windows);
  void commit(ShearedBox const& end, std::int64_t steps);
  void adapt_allowance();
  void count(Lookahead& lookahead);

  BlockDisks& disks_;
  ContactDetector& detector_;
  ForecastList list_;
  std::int64_t arrangement_ = 0;  ///< of the system, that there is room for
  IslandFinder finder_;
  Islands islands_;
  PairIslands pair_islands_;
  BatchIslands batch_islands_;
  LookaheadScratch scratch_;
  std::vector<Forecast> forecast_;  ///< by block
  std::vector<SlotPair> todo_;
  std::vector<std::uint8_t> in_batch_;  ///< by slot
  std::vector<FlightSums> free_;        ///< by block
};

}  // namespace bagnold
