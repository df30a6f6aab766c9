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
  auto const steps_of = [&](SequencePiece const& piece) {
    double const time = piece.rate == 0 ? piece.amount : piece.amount / std::abs(piece.rate);
    return std::max(1.0, std::round(time / dt));
  };
  double steps = 0;
  for (auto const& piece : shear.pieces) steps += steps_of(piece);
  steps *= static_cast<double>(shear.cycles);
  if (!(steps * static_cast<double>(scene.disks.replicas) <= most_steps))
    throw InputError(
        fmt::format("shear.pieces take {:.3g} steps (limit {:.0g}); raise their rates, or lower "
                    "their strains or times",
                    steps, most_steps));
  PieceTable table(dt, shear.cycles);
  for (auto const& piece : shear.pieces) {
    double const taken = steps_of(piece) * dt;
    double const wanted = piece.rate == 0 ? piece.amount : piece.amount / std::abs(piece.rate);
    if (std::abs(taken / wanted - 1) > most_change)
      throw InputError(fmt::format(
          "shear.pieces: [{}, {}] takes {:.3g} steps of {} tau_e (whole ones change its rate or "
          "time by more than {:g}); take a longer piece, or a smaller integration.time_step",
          piece.rate, piece.amount, wanted / dt, dt, most_change));
    // the strain is kept, and the rate fits the steps
    table.add(static_cast<std::int64_t>(steps_of(piece)),
              piece.rate == 0 ? 0 : std::copysign(piece.amount / taken, piece.rate));
  }
  return table;
}

}  // namespace bagnold
