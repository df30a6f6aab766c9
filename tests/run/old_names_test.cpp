// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>

#include "src/io/checkpoint.hpp"
#include "tests/support/simulations.hpp"

namespace bagnold::test {
namespace {

using Numbers = std::map<std::string, double>;

/// What version 0.1.0 wrote of the engine on blocks, and each name today.
std::map<std::string, std::string> const memory_before = {
    {"enter_windows_below", "enter_lookahead_below"},
    {"fastest", "fastest"},
    {"few_contacts", "few_contacts"},
    {"in_windows", "looking_ahead"},
    {"inner_drift", "inner_nonaffine_bound"},
    {"inner_margin", "inner_margin"},
    {"lost_in_windows", "lost_in_lookahead"},
    {"lost_since_entry", "lost_since_entry"},
    {"near_pairs", "near_pairs"},
    {"outer_drift", "outer_nonaffine_bound"},
    {"prune_step", "prune_step"},
    {"touching", "touching"},
    {"usual_contacts", "usual_contacts"},
    {"window_allowance", "lookahead_allowance"},
    {"window_allowance_steps", "lookahead_allowance_steps"},
    {"window_cautious", "lookahead_cautious"},
    {"window_cost", "lookahead_cost"},
    {"window_level", "lookahead_level"},
    {"window_phase", "lookahead_phase"},
    {"window_trial_cost", "lookahead_trial_cost"},
    {"window_usual_stray", "lookahead_usual_deviation"}};
std::map<std::string, std::string> const counters_before = {
    {"binary_islands", "binary_islands"},
    {"binary_steps", "binary_steps"},
    {"disks_in_larger_islands", "disks_in_larger_islands"},
    {"pairs_evaluated", "pairs_evaluated"},
    {"pairs_missed_and_added", "pairs_missed_and_added"},
    {"prunings", "prunings"},
    {"steps_dense", "steps_few_contacts"},
    {"steps_in_windows", "lookahead_steps"},
    {"steps_one_by_one", "steps_one_by_one"},
    {"touching_in_windows", "touching_in_lookahead"},
    {"windows", "lookaheads"},
    {"windows_refused", "lookaheads_refused"}};

Numbers with_names_of_before(Numbers const& now, std::map<std::string, std::string> const& names) {
  Numbers before;
  for (auto const& [old_name, name] : names) before[old_name] = now.at(name);
  return before;
}

/// What is read from a checkpoint that has the old names.
io::SystemCheckpoint through_an_old_file(Snapshot const& left) {
  io::Checkpoint checkpoint;
  checkpoint.systems.resize(1);
  auto& system = checkpoint.systems.front();
  static_cast<Snapshot&>(system) = left;
  system.columns = 1;
  system.memory = with_names_of_before(left.memory, memory_before);
  system.counters = with_names_of_before(left.counters, counters_before);
  system.frames = {{"contacts_looks", {1.5, 2.5}}};
  return io::parse_checkpoint("old", io::checkpoint_image(checkpoint)).systems.front();
}

class NamesOfBefore : public testing::TestWithParam<char const*> {
 public:
  Scene scene() const {
    Scene scene = small_scene("CD_rot", GetParam() == std::string("lookahead") ? 0.7 : 0.82, 300);
    scene.integration.engine = GetParam();
    return scene;
  }
};

INSTANTIATE_TEST_SUITE_P(Engines, NamesOfBefore,
                         testing::Values("few-contacts", "many-contacts", "lookahead"),
                         [](auto const& info) {
                           std::string name = info.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST_P(NamesOfBefore, AreReadAsThoseOfTodayAndGoOnWithTheSameBits) {
  auto const straight = simulate(scene(), shaken_start(scene()), "serial");
  advance(*straight, 300);
  Snapshot const left = straight->snapshot();
  ASSERT_GT(left.memory.at("outer_nonaffine_bound"), 0);
  auto const read = through_an_old_file(left);
  EXPECT_EQ(read.memory, left.memory);
  EXPECT_EQ(read.counters, left.counters);
  EXPECT_EQ(read.frames.at("contacts_samples"), (std::vector{1.5, 2.5}));

  auto const resumed = make_simulation(scene(), read, "serial");
  advance(*straight, 200);
  advance(*resumed, 200);
  State const a = straight->state(), b = resumed->state();
  EXPECT_EQ(a.position, b.position);
  EXPECT_EQ(a.velocity, b.velocity);
  EXPECT_EQ(a.spin, b.spin);
  EXPECT_EQ(straight->snapshot().memory, resumed->snapshot().memory);
  EXPECT_EQ(straight->snapshot().counters, resumed->snapshot().counters);
}

}  // namespace
}  // namespace bagnold::test
