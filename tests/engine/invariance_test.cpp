// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/simulations.hpp"

namespace bagnold::test {

/// What must not matter does not: the same system described differently moves the same.
class Invariance : public EverySimulation {
 public:
  static constexpr int steps = 200;

  Scene scene(double aspect = 1.0) const {
    Scene scene = small_scene(0.84);
    scene.disks.box_aspect = aspect;
    return scene;
  }

  static constexpr double aspects[] = {1.0, 4.0, 0.25};

  /// Largest difference after some steps of two descriptions; `shift` is taken off the second.
  double difference(State const& a, State const& b, std::array<double, 2> shift = {0, 0}) const {
    auto const one = simulate(scene(), a, backend());
    auto const other = simulate(scene(), b, backend());
    advance(*one, steps);
    advance(*other, steps);
    State moved = other->state();
    for (std::size_t i = 0; i < moved.count(); ++i) {
      moved.position[i][0] -= shift[0] + shift[1] * scene().shear.strain_rate * time(steps);
      moved.position[i][1] -= shift[1];
      moved.velocity[i][0] -= shift[1] * scene().shear.strain_rate;
    }
    return largest_difference(one->state(), moved, scene().shear.strain_rate);
  }

  double time(int n) const { return n * scene().integration.time_step.number.value(); }
};

/// By as much strain as takes the images to where others were: whole widths of the box.
TEST_P(Invariance, UnderAWholeStrain) {
  for (double const aspect : aspects) {
    State const state = shaken_start(scene(aspect));
    for (double whole : {1.0, 3.0, -2.0}) {
      State more = state;
      more.offset += whole * more.box_length;
      EXPECT_LT(difference(state, more), 1e-12) << whole << " at " << aspect;
    }
  }
}

/// Shifting the origin by (a, b) is a change to a frame moving with gammadot b: at time 0, and with
/// the offset gamma L there, disks shift by (a, b) and velocities by gammadot b.
TEST_P(Invariance, UnderAShiftOfTheOrigin) {
  double const a = 1.37, b = 2.71;
  for (double const aspect : aspects) {
    State const state = shaken_start(scene(aspect));
    State shifted = state;
    for (std::size_t i = 0; i < state.count(); ++i) {
      shifted.position[i][0] += a;
      shifted.position[i][1] += b;
      shifted.velocity[i][0] += scene().shear.strain_rate * b;
    }
    EXPECT_LT(difference(state, shifted, {a, b}), 1e-11) << aspect;
  }
}

TEST_P(Invariance, UnderReimagingOfDisks) {
  for (double const aspect : aspects) {
    State const state = shaken_start(scene(aspect));
    State other = state;
    for (std::size_t i = 0; i < state.count(); i += 3) {
      int const n = static_cast<int>(i % 5) - 2, m = static_cast<int>(i % 7) - 3;
      other.position[i][0] += m * state.box_length + n * state.offset;
      other.position[i][1] += n * state.box_height();
      other.velocity[i][0] += n * scene().shear.strain_rate * state.box_height();
    }
    EXPECT_LT(difference(state, other), 1e-12) << aspect;
  }
}

/// CD_nt at its ends: k_t = 0 is CD_n, k_t = k_n is CD_rot.
TEST_P(Invariance, GeneralLawHasCDnAndCDrotAsItsEnds) {
  if (law() != "CD_n" && law() != "CD_rot") GTEST_SKIP() << "not an end";
  State const state = shaken_start(scene());
  Scene general = scene();
  general.disks.model = "CD_nt";
  general.disks.damping_normal = 1.0;
  general.disks.damping_tangential = law() == "CD_n" ? 0.0 : 1.0;
  State with_spins = state;
  if (state.spin.empty()) with_spins.spin.assign(state.count(), 0.1);  // must not matter
  auto const end = simulate(scene(), state, backend());
  auto const same = simulate(general, with_spins, backend());
  advance(*end, steps);
  advance(*same, steps);
  State const a = end->state();
  State b = same->state();
  if (a.spin.empty()) b.spin.clear();
  EXPECT_LT(largest_difference(a, b, scene().shear.strain_rate), 1e-12);
}

BAGNOLD_FOR_EVERY_SIMULATION(Invariance);

}  // namespace bagnold::test
