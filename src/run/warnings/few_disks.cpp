// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "src/run/warnings/checks.hpp"

namespace bagnold {

std::optional<Warning> few_disks(FinishedRun const& finished) {
  auto const count = finished.run.scene.disks.count;
  if (count >= 100) return {};
  return Warning{"few_disks",
                 {{"count", static_cast<double>(count)}},
                 fmt::format("{} disks are few", count),
                 "raise disks.count"};
}

}  // namespace bagnold
