// SPDX-License-Identifier: BSD-3-Clause
//
// Pieces that are decided on as a run goes: another strain rate, another box.
#include <cmath>

#include "kernels/physics/type_list.hpp"
#include "tests/support/scheduled_reference.hpp"
#include "tests/support/simulations.hpp"

namespace bagnold::test {

namespace {

struct Piece {
  std::int64_t steps;
  double rate, scale;  ///< at its end: of the next one
};

constexpr Piece pieces[] = {{40, 2e-2, 1.0},  {30, -5e-3, 0.999}, {25, -1e-2, 1.002},
                            {50, 0.0, 0.998}, {20, 1e-2, 1.001},  {60, 1e-2, 0.997},
                            {60, 1e-2, 1.0}};

/// All pairs of a state, mapped affinely into another box, at another rate.
reference::System changed(reference::System const& from, Piece const& piece) {
  State s = from.s;
  double const before = from.p.strain_rate, rise = before * (piece.scale - 1);
  for (std::size_t i = 0; i < s.count(); ++i) {
    s.velocity[i][0] += rise * s.position[i][1];
    for (auto& x : s.position[i]) x *= piece.scale;
    s.velocity[i][0] += (piece.rate - before) * s.position[i][1];
  }
  for (auto& spin : s.spin) spin -= (piece.rate - before) / 2;
  s.box_length *= piece.scale;
  s.offset *= piece.scale;
  reference::Parameters p = from.p;
  p.strain_rate = piece.rate;
  return {p, s};
}

}  // namespace

class Control : public EverySimulation {
 public:
  bool is_able() const { return engine() != "lookahead"; }

  Scene scene(std::string_view scheme) const {
    Scene made = small_scene(0.84, 64);
    made.integration.scheme = scheme;
    made.integration.skin = 0.35;
    made.shear.protocol = "pressure";
    made.shear.pressure = 1e-2;
    return made;
  }
};

TEST_P(Control, PiecesAreThoseOfTheAllPairsReference) {
  if (!is_able() || backend() != backend_names().front()) return;
  for (auto const scheme : names_of<Schemes>()) {
    if (is_implicit(scheme) && engine() == "few-contacts") continue;
    SCOPED_TRACE(scheme);
    Scene const of = scene(scheme);
    State const state = shaken_start(of);
    auto const simulation = simulate(of, state, backend());
    reference::System oracle(reference_parameters(of), state);
    for (auto const& piece : pieces) {
      for (std::int64_t k = 0; k < piece.steps; ++k) reference_step(oracle, of.integration.scheme);
      advance(*simulation, piece.steps);
      oracle = changed(oracle, piece);
      simulation->begin_piece(piece.rate, piece.scale);
      auto const found = simulation->state();
      EXPECT_NEAR(found.box_length, oracle.s.box_length, 1e-13 * found.box_length);
      EXPECT_EQ(found.strain_rate, piece.rate);
      EXPECT_LT(largest_difference(found, oracle.s, piece.rate), 1e-10);
    }
    EXPECT_GE(reference::contacts(oracle).size(), 50u);
  }
}

/// A run that is cut, snapshot and continued has the bits of one that was not.
TEST_P(Control, GoesOnFromASnapshot) {
  if (!is_able()) return;
  for (auto const scheme : names_of<Schemes>()) {
    if (is_implicit(scheme) && engine() == "few-contacts") continue;
    SCOPED_TRACE(scheme);
    Scene const of = scene(scheme);
    State const state = shaken_start(of);
    auto const whole = simulate(of, state, backend());
    auto cut = simulate(of, state, backend());
    for (auto const& piece : pieces) {
      advance(*whole, piece.steps);
      for (std::int64_t done = 0; done < piece.steps; done += 17) {
        advance(*cut, std::min<std::int64_t>(17, piece.steps - done));
        cut = make_simulation(of, cut->snapshot(), backend());
      }
      whole->begin_piece(piece.rate, piece.scale);
      cut->begin_piece(piece.rate, piece.scale);
    }
    EXPECT_EQ(cut->state().position, whole->state().position);
    EXPECT_EQ(cut->state().velocity, whole->state().velocity);
    EXPECT_EQ(cut->state().spin, whole->state().spin);
    EXPECT_EQ(cut->state().offset, whole->state().offset);
  }
}

BAGNOLD_FOR_EVERY_SIMULATION(Control);

}  // namespace bagnold::test
