// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/simulations.hpp"

namespace bagnold::test {
namespace {

/// A state to audit in: where the fast engine is in its element, or at its limits.
struct Case {
  char const* name;
  char const* law;
  double packing_fraction, elasticity, strain_rate;
  double warm_up;        ///< strain before the audit
  std::int64_t steps;    ///< between comparisons
  double pair_contacts;  ///< to audit: pairs that touch, summed over steps
};

/// Pairs whose gap is smaller than `within` either way, [d_s], so that rounding decides if they
/// touch.
int grazing(State const& s, double within) {
  int found = 0;
  double const L = s.box_length;
  for (std::size_t i = 0; i < s.count(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (int n = -1; n <= 1; ++n)
        for (int m = -2; m <= 2; ++m) {
          double const x = s.position[i][0] - s.position[j][0] - m * L - n * s.offset;
          double const y = s.position[i][1] - s.position[j][1] - n * L;
          double const distance = (s.diameter[i] + s.diameter[j]) / 2;
          found += std::abs(std::sqrt(x * x + y * y) - distance) < within;
        }
  return found;
}

/// The same over the configurations that a run of `steps` steps evaluates.
int grazing(Scene const& scene, State const& start, std::int64_t steps, double within) {
  auto const simulation = simulate(scene, start, backend_names().front());
  int found = 0;
  for (std::int64_t k = 0; k < steps; ++k) {
    found += grazing(simulation->state(), within);
    advance(*simulation, 1);
  }
  return found;
}

/// A long run of the automatic engine, compared stretch by stretch with the reference engine
/// started from the same state. The reference evaluates every pair of its list at every step, so a
/// contact missed or one too many at any step shows in the number of contacts, which must be equal.
/// Stretches are short: collisions multiply rounding by up to d/gap each, and an overdamped contact
/// opens so gently that rounding may move its end by a step: numbers may differ by pairs that
/// graze, no more.
class Audit : public testing::TestWithParam<Case> {};

TEST_P(Audit, NoContactIsMissedAndNoneIsExtra) {
  Case const& c = GetParam();
  Scene scene;
  scene.disks = {c.law, 256, c.packing_fraction, c.elasticity,
                 std::string(c.law) == "CD_n" ? "area" : "equal"};
  scene.shear.strain_rate = c.strain_rate;
  scene.shear.strain = 1;
  scene.integration.scheme = papers_scheme;
  scene.integration.time_step = 0.05;
  auto const backend = backend_names().front();
  auto const fast = simulate(scene, random_start(scene).state, backend);
  double const step_strain = c.strain_rate * scene.integration.time_step.number.value();
  advance(*fast, static_cast<std::int64_t>(c.warm_up / step_strain));

  Scene plain = scene;
  plain.integration.engine = "reference";
  double audited = 0, worst = 0;
  int stretches = 0, grazed = 0;
  for (; audited < c.pair_contacts; ++stretches) {
    State const start = fast->state();
    auto const oracle = simulate(plain, start, backend);
    auto const found = advance(*fast, c.steps, 1);
    auto const expected = advance(*oracle, c.steps, 1);
    double const apart = largest_difference(fast->state(), oracle->state(), c.strain_rate);
    double const more = found.sums[SumColumns::contacts] - expected.sums[SumColumns::contacts];
    if (more != 0) {
      int const graze = grazing(plain, start, c.steps, 2 * apart);
      ASSERT_LE(std::abs(more) / 2, graze)
          << "stretch " << stretches << ", step " << fast->step() << ", states apart by " << apart;
      ++grazed;  // stretches
    }
    worst = std::max(worst, apart);
    ASSERT_LT(worst, 1e-9) << "stretch " << stretches << ", step " << fast->step();
    audited += expected.sums[SumColumns::contacts] / 2;
  }
  auto const counters = fast->snapshot().counters;
  RecordProperty("pair_contacts", std::to_string(audited));
  RecordProperty("stretches", stretches);
  RecordProperty("worst_difference", std::to_string(worst));
  EXPECT_LE(grazed, 3);  // rare
  bool const lookaheads_wanted = c.packing_fraction < 0.8;
  EXPECT_EQ(counters.at("lookaheads") > 100, lookaheads_wanted);
  EXPECT_EQ(counters.at("steps_one_by_one") > counters.at("lookahead_steps"), !lookaheads_wanted);
}

INSTANTIATE_TEST_SUITE_P(
    All, Audit,
    testing::Values(Case{"CD_n_dilute", "CD_n", 0.78, 50, 1e-4, 0.5, 400, 1e6},
                    Case{"CD_n_smaller_rate", "CD_n", 0.78, 50, 1e-5, 0.5, 2000, 2e5},
                    Case{"CD_n_clustered", "CD_n", 0.76, 1, 1e-5, 0.3, 64, 1e6},
                    Case{"CD_rot_clustered", "CD_rot", 0.74, 1, 1e-5, 0.3, 64, 1e6},
                    Case{"CD_rot_Newtonian", "CD_rot", 0.82, 1, 1e-4, 0.3, 100, 5e7},
                    Case{"CD_n_jammed", "CD_n", 0.84, 1, 1e-4, 0.3, 100, 2e7},
                    Case{"CD_Newtonian", "CD", 0.82, 10, 1e-4, 0.3, 100, 3e7}),
    [](auto const& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace bagnold::test
