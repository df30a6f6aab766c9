// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "src/run/collisions.hpp"
#include "src/run/warnings/checks.hpp"

namespace bagnold {

std::optional<Warning> few_collisions(FinishedRun const& finished) {
  double const collisions =
      collisions_per_disk(finished.run.scene, finished.mean("Z"), finished.measured_strain());
  if (!(collisions < fewest_collisions)) return {};
  return Warning{
      "few_collisions",
      {{"collisions_per_disk", collisions}},
      fmt::format(
          "a disk collides {:.2g} times at most in the measured strain of {:.3g}; it takes {:.0f} "
          "to forget the start",
          collisions, finished.measured_strain(), fewest_collisions),
      "make the run longer",
      longer_run(finished.run, 1.5 * fewest_collisions / collisions)};
}

}  // namespace bagnold
