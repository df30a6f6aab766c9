// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/sequence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/config/errors.hpp"
#include "src/config/scene.hpp"
#include "src/config/step_counts.hpp"
#include "src/config/time_step.hpp"

namespace bagnold {

namespace {

constexpr double most_change = 0.01;  ///< of a rate or a time, by which steps become whole

}  // namespace

PieceTable make_sequence(Scene const& scene) {
  auto const& shear = scene.shear;
  double const dt = time_step(scene);
  PieceTable table(dt, shear.cycles);
  double all = 0;
  for (auto const& piece : shear.pieces) {
    double const wanted =
        (piece.rate == 0 ? piece.amount : piece.amount / std::abs(piece.rate)) / dt;
    double const steps = std::max(1.0, std::round(wanted));
    all += steps * static_cast<double>(shear.cycles * scene.disks.replicas);
    if (!(all <= most_steps))
      throw InputError(
          fmt::format("shear.pieces take {:.3g} steps and more (limit {:.0g}); raise their rates, "
                      "or lower their strains or times",
                      all, most_steps));
    if (std::abs(steps / wanted - 1) > most_change)
      throw InputError(fmt::format(
          "shear.pieces: [{}, {}] takes {:.3g} steps of {} tau_e (whole ones change its rate or "
          "time by more than {:g}); take a longer piece, or a smaller integration.time_step",
          piece.rate, piece.amount, wanted, dt, most_change));
    // the strain is kept, and the rate fits the steps
    table.add(static_cast<std::int64_t>(steps),
              piece.rate == 0 ? 0 : std::copysign(piece.amount / (steps * dt), piece.rate));
  }
  return table;
}

}  // namespace bagnold
