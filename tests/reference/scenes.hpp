// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <string>

#include "src/config/names.hpp"
#include "tests/reference/reference.hpp"
#include "tests/support/reference_law.hpp"

/// What the reference's own tests start from.
namespace bagnold::reference {

using Model = Parameters::Model;

/// Tests of every law in the program's list; of one that the reference has not they fail.
class OfEveryLaw : public testing::TestWithParam<std::string_view> {
 public:
  static std::string name(testing::TestParamInfo<std::string_view> const& info) {
    std::string name(info.param);
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
  }
};
#define BAGNOLD_FOR_EVERY_LAW(Suite) \
  INSTANTIATE_TEST_SUITE_P(Reference, Suite, testing::ValuesIn(model_names()), Suite::name)

/// Of the law of that name in the program's list. Throws NoFormula.
inline Parameters parameters(std::string_view law, double elasticity = 2.0) {
  Scene::Disks disks;
  disks.model = law;
  disks.elasticity = elasticity;
  disks.damping_normal = 0.7;  // only `CD_nt` reads these two
  disks.damping_tangential = 1.6;
  Parameters p;
  test::set_law(p, disks);
  p.strain_rate = 0.05;
  return p;
}

/// One of the papers' laws.
inline Parameters parameters(Model model) {
  Parameters p = parameters("CD_nt");
  p.model = model;
  return p;
}

/// A square grid, spacing 0.9, small and big disks by turns, a little shaken: every disk overlaps
/// four neighbours by about 0.3 and big ones their diagonals by 0.13, so that contacts last.
inline State packed(std::size_t side, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> shake(-0.02, 0.02);
  State s;
  double const spacing = 0.9;
  s.box_length = spacing * static_cast<double>(side);
  for (std::size_t row = 0; row < side; ++row) {
    for (std::size_t column = 0; column < side; ++column) {
      double const x = spacing * (static_cast<double>(column) + 0.5);
      double const y = spacing * (static_cast<double>(row) + 0.5);
      s.position.push_back({x + shake(random), y + shake(random)});
      s.velocity.push_back({0.05 * s.position.back()[1] + shake(random), shake(random)});
      s.spin.push_back(shake(random));
      s.diameter.push_back((row + column) % 2 == 0 ? 1.0 : 1.4);
    }
  }
  return s;
}

/// Disks anywhere, at area fraction about 0.9, with large overlaps and velocities of order 1.
inline State scattered(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  State s;
  s.box_length = std::sqrt(1.16 / 0.9 * static_cast<double>(count));
  for (std::size_t i = 0; i < count; ++i) {
    s.position.push_back({s.box_length * unit(random), s.box_length * unit(random)});
    s.velocity.push_back({unit(random) - 0.5, unit(random) - 0.5});
    s.spin.push_back(unit(random) - 0.5);
    s.diameter.push_back(i % 2 == 0 ? 1.0 : 1.4);
  }
  return s;
}

}  // namespace bagnold::reference
