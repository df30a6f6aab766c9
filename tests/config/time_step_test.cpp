// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/time_step.hpp"

#include <gtest/gtest.h>

#include "src/config/skin.hpp"
#include "src/config/stability.hpp"
#include "tests/config/scenes.hpp"
#include "tests/support/schemes.hpp"

namespace bagnold {
namespace {

/// P1 Sec. II C: dt = min{0.5/Q, 0.1, 0.2 Q}.
TEST(PaperTimeStep, OfP1) {
  for (auto const* model : {"CD_n", "CD_nt"}) {
    EXPECT_DOUBLE_EQ(paper_time_step(disks(model, 0.1)), 0.02);
    EXPECT_DOUBLE_EQ(paper_time_step(disks(model, 0.5)), 0.1);
    EXPECT_DOUBLE_EQ(paper_time_step(disks(model, 1)), 0.1);
    EXPECT_DOUBLE_EQ(paper_time_step(disks(model, 5)), 0.1);
    EXPECT_DOUBLE_EQ(paper_time_step(disks(model, 50)), 0.01);
    EXPECT_DOUBLE_EQ(paper_time_step(disks(model, 500)), 0.001);
  }
}

/// P2 Sec. II D: 0.05; below Q = 0.5 down to 0.01.
TEST(PaperTimeStep, OfP2) {
  for (auto const* model : {"CD", "CD_rot"}) {
    for (double const q : {0.5, 1.0, 50.0, 1e4}) EXPECT_EQ(paper_time_step(disks(model, q)), 0.05);
    EXPECT_DOUBLE_EQ(paper_time_step(disks(model, 0.3)), 0.03);
    EXPECT_DOUBLE_EQ(paper_time_step(disks(model, 0.1)), 0.01);
    EXPECT_DOUBLE_EQ(paper_time_step(disks(model, 0.001)), 0.01);
  }
}

/// docs/accuracy.md, "Which step": min{0.2, 0.2 Q} where disks rotate, otherwise min{0.2, 0.5 Q}.
TEST(TwoStageTimeStep, OfEachLaw) {
  Scene scene = minimal_scene();
  auto const rule = [&](char const* model, double q) {
    scene.disks = disks(model, q);
    return rule_time_step(scene, two_stage_scheme);
  };
  for (double const q : {1.0, 50.0, 500.0})
    for (auto const* model : {"CD", "CD_n", "CD_rot", "CD_nt"}) EXPECT_EQ(rule(model, q), 0.2);
  for (auto const* model : {"CD", "CD_n"}) {
    EXPECT_EQ(rule(model, 0.4), 0.2);
    EXPECT_DOUBLE_EQ(rule(model, 0.1), 0.05);
  }
  for (auto const* model : {"CD_rot", "CD_nt"}) EXPECT_DOUBLE_EQ(rule(model, 0.1), 0.02);
  scene.disks.damping_tangential = 4;
  EXPECT_DOUBLE_EQ(rule_time_step(scene, two_stage_scheme), 0.005);
}

TEST(TimeStep, AsGivenOrByTheRuleNamed) {
  Scene scene = minimal_scene();
  EXPECT_EQ(time_step(scene), 0.2);
  scene.integration.time_step = of_papers;
  EXPECT_EQ(time_step(scene), 0.05);
  scene.integration.time_step = 0.0123;
  EXPECT_EQ(time_step(scene), 0.0123);
  scene.integration.scheme = papers_scheme;
  EXPECT_EQ(time_step(scene), 0.0123);
  for (auto const* word : {automatic, of_papers}) {
    scene.integration.time_step = word;
    EXPECT_EQ(time_step(scene), 0.05);
  }
}

TEST(Scheme, TwoStagesUnlessNamed) {
  Scene scene = minimal_scene();
  EXPECT_EQ(scheme_of(scene), two_stage_scheme);
  for (auto const name : {papers_scheme, two_stage_scheme}) {
    scene.integration.scheme = name;
    EXPECT_EQ(scheme_of(scene), name);
  }
}

/// So a number given for dt is no reason to fall back: whatever a contact bears with the papers'
/// scheme it bears with two stages.
TEST(Scheme, TwoStagesBearWhatThePapersBear) {
  int borne = 0;
  for (auto const* model : {"CD", "CD_n", "CD_rot", "CD_nt"})
    for (auto const* mass : {"equal", "area"})
      for (double q = 1e-3; q < 2e3; q *= 1.3)
        for (double dt = 1e-4; dt < 10; dt *= 1.05) {
          Scene scene;
          scene.disks = disks(model, q, mass);
          if (contact_spectral_radius(scene, papers_scheme, dt) > 1) continue;
          ++borne;
          EXPECT_LE(contact_spectral_radius(scene, two_stage_scheme, dt), 1 + 1e-12)
              << model << " " << mass << " Q = " << q << " dt = " << dt;
        }
  EXPECT_GT(borne, 10'000);
}

/// k_n alone holds the stiff motions, along normals; laws of one constant keep their rule.
TEST(ImplicitDampingRule, GoesByTheNormalDamping) {
  auto const step = [](double normal, double tangential, double q = 1.0) {
    Scene scene;
    scene.disks = disks("CD_nt", q);
    scene.disks.damping_normal = normal;
    scene.disks.damping_tangential = tangential;
    return rule_time_step(scene, "implicit-damping");
  };
  EXPECT_DOUBLE_EQ(step(1, 1), 1.8);
  EXPECT_DOUBLE_EQ(step(1, 0.5), 1.4);
  EXPECT_DOUBLE_EQ(step(0.5, 1), 1.8 / std::cbrt(2));
  EXPECT_DOUBLE_EQ(step(0.5, 1, 10), 1.8 / std::cbrt(20));
  EXPECT_DOUBLE_EQ(step(0, 1), 0.2);
  EXPECT_DOUBLE_EQ(step(0, 0), 0.2);
  EXPECT_DOUBLE_EQ(step(1, 0.2), 0.2);
}

/// The rule's own step is below what a dense flow bears, and steps that make energy (CD_nt at phi =
/// 0.86, k_n = 0.2 k_t, 1.4 tau_e: T_g is 300 times too large) are above it.
TEST(ImplicitDampingRule, BearsADenseFlow) {
  Scene scene;
  for (auto const* model : {"CD", "CD_rot"})
    for (auto const* mass : {"equal", "area"})
      for (double q = 0.1; q < 300; q *= 1.2) {
        scene.disks = disks(model, q, mass);
        EXPECT_LE(rule_time_step(scene, "implicit-damping"),
                  dense_flow_time_step(scene, "implicit-damping"))
            << model << " " << mass << " " << q;
      }
  scene.disks = disks("CD_nt", 1);
  scene.disks.damping_normal = 0.2;
  EXPECT_LT(dense_flow_time_step(scene, "implicit-damping"), 1.4);
  EXPECT_LT(largest_stable_time_step(scene, "implicit-damping"), 1.4);
}

TEST(Skin, IsWideForImplicitDampingWhereTheBoxHasRoom) {
  Scene scene = minimal_scene();
  scene.integration.scheme = "implicit-damping";
  scene.disks.count = 1024;
  EXPECT_EQ(skin(scene), 0.5);
  scene.disks.count = 10;
  EXPECT_LT(scene.box_length(), 2 * (1.4 + 0.5));
  EXPECT_EQ(skin(scene), usual_skin);
  scene.integration.skin = 0.2;
  EXPECT_EQ(skin(scene), 0.2);
}

TEST(Resolved, HasNoWords) {
  Scene const scene = minimal_scene();
  EXPECT_EQ(resolved(scene).integration.scheme, two_stage_scheme);
  EXPECT_EQ(resolved(scene).integration.time_step, 0.2);
  EXPECT_EQ(resolved(scene).integration.skin, usual_skin);
  EXPECT_EQ(write_scene(resolved(resolved(scene))), write_scene(resolved(scene)));
}

}  // namespace
}  // namespace bagnold
