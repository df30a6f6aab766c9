// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/protocols/ramp/ramped_simulation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bagnold {

RampedSimulation::RampedSimulation(Ramp const& ramp, Make make, Snapshot&& snapshot)
    : ramp_(ramp), make_(std::move(make)), initial_offset_(snapshot.initial_offset) {
  // past the end there is no piece: a finished run is still that of its last one
  auto const piece = ramp_.piece(std::min(snapshot.step, ramp_.steps() - 1));
  snapshot.initial_offset = offset_of(piece, snapshot.state);
  piece_ = make_(piece.rate, std::move(snapshot));
}

/// What the offset at step 0 would have been, had all steps been at this piece's rate: a simulation
/// at one rate counts strain from there.
double RampedSimulation::offset_of(Ramp::Piece const& piece, State const& box) const {
  long double const at_one_rate = static_cast<long double>(piece.begin) *
                                  (static_cast<long double>(piece.rate) * ramp_.time_step);
  long double turns = initial_offset_ / static_cast<long double>(box.box_length) +
                      box.box_aspect * (ramp_.strain(piece.begin) - at_one_rate);
  turns -= std::floor(turns);
  return static_cast<double>(turns * box.box_length);
}

void RampedSimulation::advance(std::int64_t steps, Sampling const& sampling, OpenWindows& windows) {
  auto const end = std::min(step() + steps, sampling.last_step);
  while (step() < end) {
    auto const piece = ramp_.piece(step());
    Sampling of_piece = sampling;
    of_piece.last_step = std::min(sampling.last_step, piece.end);
    piece_->advance(end - step(), of_piece, windows);
    if (step() == piece.end && step() < ramp_.steps()) next_piece();
  }
}

void RampedSimulation::next_piece() {
  auto const old = ramp_.piece(step() - 1), next = ramp_.piece(step());
  Snapshot snapshot;
  snapshot.state = piece_->state();
  double const ratio = next.rate / old.rate;
  for (auto& v : snapshot.state.velocity) v = {v[0] * ratio, v[1] * ratio};
  for (auto& spin : snapshot.state.spin) spin *= ratio;
  auto const before = piece_->snapshot();
  snapshot.state.strain_rate = next.rate;
  snapshot.step = step();
  snapshot.initial_offset = offset_of(next, snapshot.state);
  snapshot.initial_time = before.initial_time;
  snapshot.list_builds = before.list_builds;
  piece_ = make_(next.rate, std::move(snapshot));
}

Snapshot RampedSimulation::snapshot() const {
  Snapshot snapshot = piece_->snapshot();
  snapshot.initial_offset = initial_offset_;
  return snapshot;
}

}  // namespace bagnold
