// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "src/config/jamming.hpp"
#include "src/run/warnings/checks.hpp"

namespace bagnold {

std::optional<Warning> above_jamming(FinishedRun const& finished) {
  double const phi = finished.run.scene.disks.packing_fraction;
  if (phi <= jamming_fraction) return {};
  return Warning{
      "above_jamming",
      {{"packing_fraction", phi}, {"jamming_fraction", jamming_fraction}},
      fmt::format(
          "disks.packing_fraction = {} is {:.2g} above jamming at {}, where a yield stress is "
          "left as the rate vanishes: B and eta have no limit",
          phi, phi - jamming_fraction, jamming_fraction),
      "read p and sigma instead, at several rates",
      "",
      /*is_note=*/true};
}

}  // namespace bagnold
