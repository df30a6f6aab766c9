// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "src/config/cascade.hpp"
#include "src/config/plan.hpp"
#include "tests/config/scenes.hpp"

namespace bagnold {
namespace {

TEST(Protocols, KeysOfAnotherAreRefused) {
  struct Case {
    std::string text, key, value, protocol;
  };
  for (auto const& c :
       std::vector<Case>{{minimal_text, "shear.strain_rates", "[1e-3]", "cascade"},
                         {minimal_text, "shear.ramp_rate", "1e-5", "ramp"},
                         {minimal_text, "shear.strain_rate_high", "1e-2", "ramp"},
                         {minimal_text, "shear.cycles", "2", "ramp"},
                         {minimal_text, "shear.ramp_window", "1000", "ramp"},
                         {minimal_text, "shear.ramp_every", "1", "ramp"},
                         {minimal_text, "measure.frame_decades", "0.1", "ramp"},
                         {minimal_text, "output.trajectory_decades", "0.1", "ramp"},
                         {cascade_text, "shear.strain_rate", "1e-3", "steady\" or \"ramp"},
                         {cascade_text, "shear.cycles", "1", "ramp"},
                         {minimal_text, "shear.pieces", "[[1e-4, 1]]", "sequence"},
                         {sequence_text, "shear.amplitude", "0.1", "oscillate"},
                         {oscillation_text, "output.sample_strain", "0.1", "steady"},
                         {minimal_text, "shear.stress", "1e-3", "stress"},
                         {stress_text, "shear.strain", "1", "steady"},
                         {stress_text, "shear.pressure", "1e-3", "pressure"},
                         {pressure_text, "shear.box_inertia", "1", "stress"}}) {
    std::string const message = refusal(c.text, {c.key + "=" + c.value});
    EXPECT_TRUE(has(message, c.key + " = ") &&
                has(message, "belongs to shear.protocol = \"" + c.protocol))
        << message;
    EXPECT_TRUE(has(message, "leave it out")) << message;
  }
  for (auto const* key :
       {"shear.discard=0.5", "shear.target_error={ B_p = 0.1 }", "measure.frame_strain=0.1",
        "measure.correlations=false", "output.sample_strain=0.1", "output.trajectory_strain=0.0"}) {
    std::string const message = refusal(
        minimal_text,
        {"shear.protocol=ramp", "shear.strain_rate_high=1e-2", "shear.ramp_rate=1e-4", key});
    EXPECT_TRUE(has(message, "belongs to shear.protocol = \"steady\" or \"cascade\"") &&
                has(message, ", not \"ramp\""))
        << message;
  }
}

/// A rate goes on from the contacts of the rate before, also where the first start was relaxed.
TEST(Protocols, RatesOfACascadeAreNotRelaxed) {
  auto cascade = parse(cascade_text);
  cascade.start.relax = true;
  EXPECT_TRUE(stage_of(cascade, 0, "").start.relax);
  EXPECT_FALSE(stage_of(cascade, 1, "before/state.h5").start.relax);
}

TEST(Protocols, PiecesAreWhatTheyAre) {
  EXPECT_EQ(parse(sequence_text).shear.pieces,
            (std::vector<SequencePiece>{{1e-4, 2}, {-1e-4, 2}, {0, 1e4}}));
  auto const with = [](std::string const& pieces) {
    return refusal(sequence_text, {"shear.pieces=" + pieces});
  };
  EXPECT_TRUE(has(with("[]"), "must be a list of [rate, strain]"));
  EXPECT_TRUE(has(with("[[1e-4, 1, 2]]"), "must be a list of [rate, strain]"));
  EXPECT_TRUE(has(with("[[2, 1]]"), "shear.pieces = 2 (must be"));
  EXPECT_TRUE(has(with("[[1e-4, -1]]"), "must be above 0"));
  EXPECT_TRUE(has(with("[[0, 0]]"), "must be above 0"));
  EXPECT_TRUE(has(refusal(oscillation_text, {"shear.peak_rate=1e-6"}), "are both given"));
  EXPECT_TRUE(has(refusal(with_line(oscillation_text, "period", "")), "are missing"));
  for (auto const* lost : {"1e-12", "1e-14", "1e-300"})
    EXPECT_TRUE(has(refusal(oscillation_text, {std::string("shear.amplitude=") + lost}),
                    "rounding of positions"))
        << lost;
  EXPECT_EQ(refusal(oscillation_text, {"shear.amplitude=1e-9"}), "accepted");
  EXPECT_TRUE(has(refusal(sequence_text, {"shear.discard=auto"}), "seeks one steady state"));
}

TEST(Protocols, StressAndPressureAreGiven) {
  EXPECT_EQ(parse(stress_text, {"shear.stress=[1e-3, 2e-3]"}).shear.stress.each,
            (std::vector{1e-3, 2e-3}));
  EXPECT_TRUE(has(refusal(stress_text, {"shear.stress=[1e-3, 0]"}), "must be above 0"));
  EXPECT_TRUE(has(refusal(stress_text, {"shear.discard=auto", "shear.stress=[1e-3, 2e-3]"}),
                  "with a list of stresses"));
  EXPECT_EQ(refusal(stress_text, {"shear.discard=auto"}), "accepted");
  auto const by_number = with_line(pressure_text, "strain_rate", "inertial_number = 0.01");
  EXPECT_DOUBLE_EQ(parse(by_number).shear.strain_rate, 0.01 * std::sqrt(1e-3));
  EXPECT_TRUE(same(parse(write_scene(parse(by_number))), parse(by_number)));
  EXPECT_TRUE(has(refusal(pressure_text, {"shear.inertial_number=0.01"}), "give one of the two"));
  EXPECT_TRUE(has(refusal(with_line(pressure_text, "strain_rate", "")), "are missing"));
  for (std::string const engine : {"lookahead", "events", "quasi-static"})
    for (auto const& text : {stress_text, pressure_text})
      EXPECT_TRUE(has(refusal(text, {"integration.engine=" + engine}), "shear.protocol = \""))
          << engine;
}

/// Pieces are whole steps, windows whole pieces, and all of them the run.
TEST(Protocols, ControlIsCutIntoPieces) {
  for (auto const& text : {stress_text, pressure_text}) {
    auto const plan = make_plan(parse(text));
    EXPECT_GE(plan.control_steps, 8);
    EXPECT_EQ(plan.window_steps % plan.control_steps, 0);
    EXPECT_EQ(plan.windows * plan.window_steps, plan.steps);
    EXPECT_NEAR(plan.time_step * static_cast<double>(plan.steps), 1e5, 200);
  }
  auto const list = make_plan(parse(stress_text, {"shear.stress=[1e-3, 2e-3, 1e-3]"}));
  EXPECT_EQ(list.stages, 3);
  EXPECT_EQ(list.windows % 3, 0);
}

TEST(Protocols, RequiredKeysFollowTheProtocol) {
  EXPECT_TRUE(has(refusal(minimal_text, {"shear.protocol=ramp"}), "shear.ramp_rate is missing"));
  EXPECT_TRUE(has(refusal(minimal_text, {"shear.protocol=ramp", "shear.ramp_rate=1e-4"}),
                  "shear.strain_rate_high is missing"));
  EXPECT_TRUE(
      has(refusal(with_line(cascade_text, "strain_rates", "")), "shear.strain_rates is missing"));
  Scene const ramp =
      parse(with_line(minimal_text, "strain", ""),
            {"shear.protocol=ramp", "shear.ramp_rate=1e-4", "shear.strain_rate_high=1e-2"});
  EXPECT_EQ(ramp.shear.strain, 2.0);
  EXPECT_TRUE(has(refusal(minimal_text, {"shear.protocol=ramp", "shear.ramp_rate=1e-4",
                                         "shear.strain_rate_high=1e-4"}),
                  "shear.strain_rate_high = 0.0001 (must be more than"));
}

TEST(Protocols, CascadesGoDown) {
  EXPECT_EQ(refusal(cascade_text), "accepted");
  for (auto const* rates : {"[1e-5, 1e-4, 1e-3]", "[1e-3, 1e-3, 1e-4]"})
    EXPECT_TRUE(
        has(refusal(cascade_text, {std::string("shear.strain_rates=") + rates}), "largest first"));
  EXPECT_TRUE(has(refusal(cascade_text, {"shear.strain=[1, 2]"}),
                  "has 2 numbers, shear.strain_rates has 3"));
  EXPECT_TRUE(has(refusal(cascade_text, {"shear.strain_rates=[]"}), "shear.strain_rates"));
  EXPECT_TRUE(
      has(refusal(cascade_text, {"shear.strain_rates=[1e-3, 2]"}), "shear.strain_rates = 2"));
  EXPECT_TRUE(has(refusal(cascade_text, {"shear.strain=[1, 2, \"x\"]"}), "shear.strain"));
  EXPECT_TRUE(has(refusal(minimal_text, {"shear.strain=[1, 2]"}), "a list belongs to"));
}

TEST(Protocols, StagesAreSteadyScenesFromEachOther) {
  Scene const cascade = parse(cascade_text);
  auto const runs = runs_of(cascade);
  ASSERT_EQ(runs.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(runs[k].shear.protocol, "steady");
    EXPECT_EQ(runs[k].shear.strain_rate, cascade.shear.strain_rates[k]);
    EXPECT_EQ(runs[k].shear.strain, (std::vector{10.0, 20.0, 5.5})[k]);
  }
  EXPECT_EQ(runs[0].start.kind, "random");
  EXPECT_EQ(runs[1].start.file, "../0001_strain_rate=0.001/state.h5");
  EXPECT_EQ(runs[2].start.file, "../0002_strain_rate=0.0001/state.h5");
  EXPECT_EQ(runs_of(parse(cascade_text, {"shear.strain=3"}))[2].shear.strain, 3.0);
  EXPECT_EQ(runs_of(minimal_scene()).size(), 1u);
}

TEST(Protocols, ScenesReadBackTheSame) {
  std::string const ramp_keys =
      "ramp_rate = 3e-5\nstrain_rate_high = 0.01\ncycles = 3\nprotocol = \"ramp\"\n";
  for (auto const& text :
       {cascade_text, minimal_text + ramp_keys,
        minimal_text + "target_error = { B_p = 0.02, B_sigma = 0.1 }\ndiscard = \"auto\"\n"}) {
    Scene const scene = parse(text);
    EXPECT_TRUE(same(parse(write_scene(scene)), scene)) << write_scene(scene);
  }
}

TEST(Protocols, TargetErrors) {
  EXPECT_EQ(minimal_scene().shear.target_error.size(), 0u);
  auto const with = [](std::string const& value) {
    return refusal(minimal_text, {"shear.target_error=" + value});
  };
  EXPECT_EQ(with("{ B_p = 0.02 }"), "accepted");
  EXPECT_TRUE(has(with("0.02"), "must be a table"));
  EXPECT_TRUE(has(with("{ B_p = 0 }"), "must be above 0"));
  EXPECT_TRUE(has(with("{ B_p = \"x\" }"), "must be a number"));
  EXPECT_TRUE(
      has(refusal(minimal_text, {"shear.target_error={ B_p = 0.1 }", "measure.profiles=true"}),
          "does not go with measure.profiles"));
}

TEST(Protocols, AShortenedPlanKeepsItsShare) {
  Scene scene = minimal_scene();
  scene.shear.discard = 0.25;
  Plan const whole = make_plan(scene);
  Plan const plan = shortened(scene, whole, 101);
  EXPECT_EQ(plan.windows, 101);
  EXPECT_EQ(plan.discarded_windows, 26);
  EXPECT_EQ(plan.steps, 101 * whole.window_steps);
  EXPECT_EQ(shortened(scene, whole, whole.windows).steps, whole.steps);
}

}  // namespace
}  // namespace bagnold
