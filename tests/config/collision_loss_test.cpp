// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/collision_loss.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include <vector>

#include "src/config/time_step.hpp"
#include "tests/config/scenes.hpp"
#include "tests/support/schemes.hpp"

namespace bagnold {
namespace {

std::vector<std::string> cells(std::string const& line) {
  std::vector<std::string> all;
  std::istringstream row(line);
  for (std::string cell; std::getline(row, cell, ',');) all.push_back(cell);
  return all;
}

/// Two disks in a box, stepped by the schemes of bench/accuracy: docs/data/accuracy/collision.csv.
TEST(CollisionLoss, IsThatOfTheSchemesThemselves) {
  std::ifstream file(source_folder / "docs/data/accuracy/collision.csv");
  int rows = 0;
  for (std::string line; std::getline(file, line);) {
    auto const cell = cells(line);
    if (cell.size() < 10 || cell[3] != "head-on" || cell[9].empty()) continue;
    if (cell[4] != papers_scheme && cell[4] != "two-stage") continue;
    double const q = std::stod(cell[2]);
    if (q < 1) continue;  // hardly separate: rounding of what is left
    Scene scene;
    scene.disks = disks(cell[0], q, cell[1]);
    auto const scheme = cell[4] == papers_scheme ? papers_scheme : two_stage_scheme;
    double const expected = std::stod(cell[9]);
    EXPECT_NEAR(collision_loss_error(scene, scheme, std::stod(cell[5])), expected,
                0.01 * std::abs(expected) + 1e-4)
        << line;
    ++rows;
  }
  EXPECT_GT(rows, 100);
}

TEST(CollisionLoss, NothingIsSaidWithoutAClosedForm) {
  Scene scene;
  scene.disks = disks("CD", 0.5);  // overdamped: 1/Q above 2^(1/2)
  EXPECT_EQ(collision_loss_error(scene, two_stage_scheme, 0.2), 0);
  scene.disks = disks("CD", 500);
  scene.disks.force_exponent = 2.5;
  EXPECT_EQ(collision_loss_error(scene, two_stage_scheme, 0.5), 0);
  scene.disks = disks("CD_nt", 500);
  scene.disks.damping_normal = 0;
  EXPECT_EQ(collision_loss_error(scene, two_stage_scheme, 0.5), 0);
}

TEST(CollisionLoss, RulesAreFineEnough) {
  for (auto const* model : {"CD", "CD_n", "CD_rot", "CD_nt"})
    for (auto const* mass : {"equal", "area"})
      for (double const q : {1.0, 2.0, 10.0, 50.0, 500.0, 1e4}) {
        Scene scene;
        scene.disks = disks(model, q, mass);
        for (auto const scheme : {papers_scheme, two_stage_scheme}) {
          scene.integration.scheme = scheme;
          EXPECT_LT(std::abs(collision_loss_error(scene, scheme, time_step(scene))), 0.02)
              << scheme << " " << model << " " << mass << " Q = " << q;
        }
      }
}

}  // namespace
}  // namespace bagnold
