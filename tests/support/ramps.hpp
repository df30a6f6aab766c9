// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/config/ramp.hpp"
#include "tests/support/simulations.hpp"

/// Ways through a ramp that the tests of engines share.
namespace bagnold::test {

/// Sums of one window up to a step, of every `every`-th configuration.
inline WindowSums advance_to(Simulation& simulation, std::int64_t step, std::int64_t every = 1) {
  Sampling sampling;
  sampling.every = every;
  sampling.last_step = step;
  OpenWindows windows;
  while (simulation.step() < step) simulation.advance(step - simulation.step(), sampling, windows);
  return windows.take_first();
}

/// Sums of the pieces of a ramp, each a simulation of its own at one rate, from a state, which is
/// the last one then. scene: of one rate, that of the last piece then; columns: of the sums.
template <class Simulate, class Advance>
WindowSums sums_of_pieces(Scene& scene, Ramp const& ramp, std::size_t columns, State& state,
                          Simulate const& simulate, Advance const& advance) {
  WindowSums sums{std::vector<double>(columns), 0};
  scene.shear.protocol = "steady";
  for (std::int64_t step = 0; step < ramp.steps();) {
    auto const piece = ramp.piece(step);
    double const factor = step == 0 ? 1 : piece.rate / scene.shear.strain_rate;
    for (auto& v : state.velocity) v = {factor * v[0], factor * v[1]};
    for (auto& spin : state.spin) spin *= factor;
    scene.shear.strain_rate = piece.rate;
    auto const one = simulate(scene, state);
    WindowSums const of_piece = advance(*one, piece.end - piece.begin);
    for (std::size_t c = 0; c < columns; ++c) sums.sums[c] += of_piece.sums[c];
    sums.weight += of_piece.weight;
    state = one->state();
    step = piece.end;
  }
  return sums;
}

}  // namespace bagnold::test
