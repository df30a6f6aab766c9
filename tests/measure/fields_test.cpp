// SPDX-License-Identifier: BSD-3-Clause
#include "src/measure/fields.hpp"

#include <gtest/gtest.h>

#include "src/config/plan.hpp"
#include "src/measure/local_fields.hpp"
#include "tests/measure/states.hpp"

namespace bagnold {
namespace {

constexpr double rate = 1e-3;
constexpr double circle = std::numbers::pi * field_radius * field_radius;

/// Area of a small disk at distance d that is within the circle: points on a fine grid, counted.
double counted(double d) {
  constexpr int n = 2000;
  int inside = 0, all = 0;
  for (int a = 0; a < n; ++a)
    for (int b = 0; b < n; ++b) {
      double const x = (a + 0.5) / n - 0.5, y = (b + 0.5) / n - 0.5;
      if (x * x + y * y > 0.25) continue;
      ++all;
      inside += (x + d) * (x + d) + y * y < field_radius * field_radius ? 1 : 0;
    }
  return std::numbers::pi / 4 * inside / all;
}

TEST(LocalFields, OfAPair) {
  for (double const d : {2.0, 3.6, 4.1, 4.4, 4.6}) {
    State state;
    state.box_length = 30.0;
    state.offset = 11.0;
    state.strain_rate = rate;
    state.position = {{10.0, 29.0}, {10.0 + d - 11.0 + 30.0, 29.0}};
    state.position[1] = {10.0 + 0.6 * d - 11.0 + 30.0, 29.0 + 0.8 * d - 30.0};  // through the top
    if (29.0 + 0.8 * d < 30.0) state.position[1] = {10.0 + 0.6 * d, 29.0 + 0.8 * d};
    state.velocity = {{0.029, 0.0}, {0.0, 0.0}};
    state.diameter = {1.0, 1.0};
    auto const fields = local_fields(state);
    for (double const phi : fields.packing_fraction)
      EXPECT_NEAR(phi * circle, std::numbers::pi / 4 + counted(d), 1e-5) << d;
    EXPECT_TRUE(std::isnan(fields.strain_rate[0])) << "two disks are no plane";
  }
}

TEST(LocalFields, OfAHexagonalLattice) {
  double const a = 1.05, height = a * std::sqrt(3.0) / 2;
  int const columns = 26, rows = 30;  // nearly, not quite, a square: so a strip of the box is empty
  State state;
  state.box_length = columns * a;
  state.offset = 4 * a;  // no shift, seen in the lattice
  state.strain_rate = rate;
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c) {
      double const y = (r + 0.5) * height;
      state.position.push_back({std::fmod((c + 0.25 + 0.5 * (r % 2)) * a, state.box_length), y});
      state.velocity.push_back({rate * y + 0.5 * rate * (y - 13.0), 0.0});
      state.diameter.push_back(1.0);
    }
  double expected = 0;
  for (int r = -6; r <= 6; ++r)
    for (int c = -9; c <= 9; ++c) {
      double const d = std::hypot((c + 0.5 * (r % 2)) * a, r * height);
      if (d < field_radius + 0.5)
        expected += d < field_radius - 0.5 ? std::numbers::pi / 4 : counted(d);
    }
  auto const fields = local_fields(state);
  for (std::size_t i = 0; i < state.count(); ++i) {
    if (std::abs(state.position[i][1] - 13.0) > 7) continue;
    EXPECT_NEAR(fields.packing_fraction[i], expected / circle, 1e-5);
    EXPECT_NEAR(fields.strain_rate[i], 1.5 * rate, 1e-12);
  }
}

TEST(LocalFields, OfLinearFlowAcrossTheEdges) {
  State state = test::square_lattice(20, 1.3, rate);
  state.offset = 5.0;
  for (double const found : local_fields(state).strain_rate) EXPECT_NEAR(found, rate, 1e-15);
}

TEST(Fields, HistogramsAndLastFrame) {
  Fields fields, resumed;
  State const state = test::square_lattice(20, 1.3, rate);
  fields.add({state, 7, 0.25});
  ObserverState numbers;
  fields.save(numbers);
  resumed.load(numbers);
  FrameResults results;
  resumed.report({&resumed}, results);
  auto const& phi = test::named(results.histograms, "local_phi");
  double const expected = local_fields(state).packing_fraction[0];
  for (std::size_t b = 0; b < phi.density.size(); ++b)
    EXPECT_NEAR(phi.density[b] * 0.005, phi.edges[b] <= expected && expected < phi.edges[b + 1],
                1e-9);
  auto const& last = test::named(results.samples, "fields");
  ASSERT_EQ(last.rows.size(), 400 * last.columns.size());
  EXPECT_EQ(last.rows[0], state.position[0][0]);
  EXPECT_EQ(last.rows[3], expected);
  EXPECT_EQ(test::named(results.samples, "fields_frame").rows,
            (std::vector<double>{7.0, 0.25, 26.0, 0.0}));
}

}  // namespace
}  // namespace bagnold
