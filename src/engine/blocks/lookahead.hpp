// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/engine/blocks/lookahead_gain.hpp"
#include "src/engine/blocks/meeting_results.hpp"
#include "src/engine/clock.hpp"
#include "src/engine/contacts/lookahead_contacts.hpp"

namespace bagnold {

/// Steps that are done together.
struct Lookahead {
  std::int64_t begin, end;  ///< [steps]
  Clock after;              ///< of the step `end`
  Real most_deviation;      ///< from straight flights that the outer list allows, [d_s]
  Real deviation = 0;       ///< out: the largest one, [d_s]
  Real contacts =
      0;  ///< out: pairs touching, mean over steps; of islands of two done again, both times
  LookaheadWork work = {};  ///< out

  std::int64_t steps() const { return end - begin; }
};

/// Data that the parts of a lookahead share; kept from one lookahead to the next.
struct LookaheadScratch {
  ShearedBox start;  ///< at the lookahead's first configuration
  FlightTimes flights;
  SampleTimes times;
  LookaheadContacts contacts;
  MeetingResults results;

  MeetingResults::Unit& add_unit(bool batch) {
    if (contacts) contacts.add_unit(times.bins());
    return results.add_unit(batch, times.bins());
  }
};

}  // namespace bagnold
