// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/fit/jump.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace bagnold::analysis {
namespace {

/// An interval this many times less steep than the steepest one is outside the jump.
constexpr double several = 3.0;

/// True if the change between two points is more than three of its errors.
bool is_clear(Points const& points, std::size_t low, std::size_t high, double change) {
  constexpr double clear = 3.0;
  if (!points.weighted()) return true;
  return change >
         clear * std::hypot(points.error[low] / points.y[low], points.error[high] / points.y[high]);
}

/// True if the steepest interval is `several` times as steep as the median of the intervals outside
/// the jump. A power law is steep everywhere and has no jump. Two points cannot decide.
template <class Steepness>
bool stands_out(double steepest, std::size_t low, std::size_t high, std::size_t points,
                Steepness const& steepness) {
  std::vector<double> outside;
  for (std::size_t i = 0; i + 1 < points; ++i)
    if (i < low || i >= high) outside.push_back(std::abs(steepness(i)));
  if (outside.empty()) return points == 2;
  auto const middle = outside.begin() + static_cast<std::ptrdiff_t>(outside.size() / 2);
  std::ranges::nth_element(outside, middle);
  return steepest >= several * *middle;
}

/// The jump, or why there is none.
std::variant<Jump, std::string_view> search(Points const& points, Direction direction,
                                            double least_factor) {
  check_points(points, 2, "jump");
  auto const log_y = with_logarithms(points, false, true).y;
  double const sign = direction == Direction::up ? 1.0 : -1.0;
  auto const steepness = [&](std::size_t i) {
    return sign * (log_y[i + 1] - log_y[i]) / (points.x[i + 1] - points.x[i]);
  };
  auto const change = [&](std::size_t low, std::size_t high) {
    return sign * (log_y[high] - log_y[low]);
  };
  std::size_t low = 0;
  for (std::size_t i = 1; i + 1 < points.size(); ++i)
    if (steepness(i) > steepness(low)) low = i;
  double const steepest = steepness(low);
  if (!(steepest > 0.0)) return "no interval goes that way";
  std::size_t high = low + 1;
  while (low > 0 && several * steepness(low - 1) >= steepest) --low;
  while (high + 1 < points.size() && several * steepness(high) >= steepest) ++high;
  if (low == 0 && high + 1 == points.size() && points.size() > 2)
    return "all intervals lie within it; points further out would tell a jump from a power law";
  if (!stands_out(steepest, low, high, points.size(), steepness))
    return "its steepest interval is less than three times as steep as those outside";
  if (change(low, high) < std::log(least_factor)) return "y changes by less than --least-factor";
  if (!is_clear(points, low, high, change(low, high)))
    return "y changes by less than three of its errors";

  double const middle = (log_y[low] + log_y[high]) / 2.0;
  std::size_t i = low;
  while (sign * (log_y[i + 1] - middle) < 0.0) ++i;
  double const width = points.x[i + 1] - points.x[i];
  double const share = (middle - log_y[i]) / (log_y[i + 1] - log_y[i]);
  return Jump{points.x[i] + share * width, width / std::sqrt(12.0), points.y[low], points.y[high]};
}

}  // namespace

std::optional<Jump> find_jump(Points const& points, Direction direction, double least_factor) {
  auto const found = search(points, direction, least_factor);
  auto const* const jump = std::get_if<Jump>(&found);
  return jump ? std::optional(*jump) : std::nullopt;
}

std::string_view why_no_jump(Points const& points, Direction direction, double least_factor) {
  auto const found = search(points, direction, least_factor);
  auto const* const reason = std::get_if<std::string_view>(&found);
  return reason ? *reason : std::string_view{};
}

}  // namespace bagnold::analysis
