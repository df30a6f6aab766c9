// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/simulations.hpp"

namespace bagnold::test {
namespace {

/// A state to audit in: where the fast engine is in its element, or at its limits.
struct Case {
  char const* name;
  char const* law;
  double packing_fraction, elasticity, strain_rate;
  double warm_up;            ///< strain before the audit
  std::int64_t steps;        ///< between comparisons
  double pair_contacts;      ///< to audit: pairs that touch, summed over steps
};

/// A long run of the automatic engine, compared stretch by stretch with the reference engine started
/// from the same state. The reference evaluates every pair of its list at every step, so a contact
/// missed or one too many at any step shows in the number of contacts, which must be equal. Stretches
/// are short: collisions multiply rounding by up to d/gap each, and an overdamped contact opens so
/// gently that rounding may move its end by a step.
class Audit : public testing::TestWithParam<Case> {};

TEST_P(Audit, NoContactIsMissedAndNoneIsExtra) {
  Case const& c = GetParam();
  Scene scene;
  scene.disks = {c.law, 256, c.packing_fraction, c.elasticity,
                 std::string(c.law) == "CD_n" ? "area" : "equal"};
  scene.shear.strain_rate = c.strain_rate;
  scene.shear.strain = 1;
  scene.integration.time_step = 0.05;
  auto const backend = backend_names().front();
  auto const fast = simulate(scene, random_start(scene).state, backend);
  double const step_strain = c.strain_rate * scene.integration.time_step.value();
  advance(*fast, static_cast<std::int64_t>(c.warm_up / step_strain));

  Scene plain = scene;
  plain.integration.engine = "reference";
  double audited = 0, worst = 0;
  int stretches = 0;
  for (; audited < c.pair_contacts; ++stretches) {
    auto const oracle = simulate(plain, fast->state(), backend);
    auto const found = advance(*fast, c.steps, 1);
    auto const expected = advance(*oracle, c.steps, 1);
    ASSERT_EQ(found.sums[SumColumns::contacts], expected.sums[SumColumns::contacts])
        << "stretch " << stretches << ", step " << fast->step() << ", states apart by "
        << largest_difference(fast->state(), oracle->state(), c.strain_rate);
    worst = std::max(worst, largest_difference(fast->state(), oracle->state(), c.strain_rate));
    ASSERT_LT(worst, 1e-9) << "stretch " << stretches << ", step " << fast->step();
    audited += expected.sums[SumColumns::contacts] / 2;
  }
  auto const counters = fast->snapshot().engine;
  RecordProperty("pair_contacts", std::to_string(audited));
  RecordProperty("stretches", stretches);
  RecordProperty("worst_difference", std::to_string(worst));
  bool const windows_wanted = c.packing_fraction < 0.8;
  EXPECT_EQ(counters.at("windows") > 100, windows_wanted);
  EXPECT_EQ(counters.at("steps_one_by_one") > counters.at("steps_in_windows"), !windows_wanted);
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
