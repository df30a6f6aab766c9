// SPDX-License-Identifier: BSD-3-Clause
#include "src/start/even_out.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

namespace bagnold {

namespace {

using Field = std::vector<double>;

/// A periodic grid of squares, about 8 d_s wide: some 50 disks each.
class Squares {
 public:
  explicit Squares(State const& state)
      : columns_(along(state.box_length)),
        rows_(along(state.box_height())),
        width_(state.box_length / static_cast<double>(columns_)),
        height_(state.box_height() / static_cast<double>(rows_)) {}

  Field zeros() const { return Field(columns_ * rows_, 0.0); }

  /// Calls visit(square, share) for the four squares whose centres surround a point in the box,
  /// with bilinear shares.
  template <class Visit>
  void around(std::array<double, 2> const& point, Visit const& visit) const {
    double const x = point[0] / width_ + static_cast<double>(columns_) - 0.5;
    double const y = point[1] / height_ + static_cast<double>(rows_) - 0.5;
    auto const column = static_cast<std::size_t>(x), row = static_cast<std::size_t>(y);
    double const right = x - static_cast<double>(column), up = y - static_cast<double>(row);
    visit(at(column, row), (1 - right) * (1 - up));
    visit(at(column + 1, row), right * (1 - up));
    visit(at(column, row + 1), (1 - right) * up);
    visit(at(column + 1, row + 1), right * up);
  }

  Field minus_laplacian(Field const& f) const {
    Field result = zeros();
    for_each([&](std::size_t here, std::size_t left, std::size_t right, std::size_t below,
                 std::size_t above) {
      result[here] = (2 * f[here] - f[left] - f[right]) / (width_ * width_) +
                     (2 * f[here] - f[below] - f[above]) / (height_ * height_);
    });
    return result;
  }

  /// Components of the gradient.
  std::array<Field, 2> gradient(Field const& f) const {
    std::array<Field, 2> result{zeros(), zeros()};
    for_each([&](std::size_t here, std::size_t left, std::size_t right, std::size_t below,
                 std::size_t above) {
      result[0][here] = (f[right] - f[left]) / (2 * width_);
      result[1][here] = (f[above] - f[below]) / (2 * height_);
    });
    return result;
  }

 private:
  static std::size_t along(double length) {
    return static_cast<std::size_t>(std::max(3.0, std::floor(length / 8)));
  }

  std::size_t at(std::size_t column, std::size_t row) const {
    return row % rows_ * columns_ + column % columns_;
  }

  template <class Visit>
  void for_each(Visit const& visit) const {
    for (std::size_t row = 0; row < rows_; ++row)
      for (std::size_t column = 0; column < columns_; ++column)
        visit(at(column, row), at(column + columns_ - 1, row), at(column + 1, row),
              at(column, row + rows_ - 1), at(column, row + 1));
  }

  std::size_t columns_, rows_;
  double width_, height_;  // [d_s]
};

Field relative_density(State const& state, Squares const& squares) {
  Field area = squares.zeros();
  for (std::size_t i = 0; i < state.count(); ++i)
    squares.around(state.position[i], [&](std::size_t square, double share) {
      area[square] += share * state.diameter[i] * state.diameter[i];
    });
  double const mean =
      std::accumulate(area.begin(), area.end(), 0.0) / static_cast<double>(area.size());
  for (double& a : area) a = a / mean - 1;
  return area;
}

double dot(Field const& a, Field const& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

/// Solves Laplace psi = delta to a thousandth of delta, by conjugate gradients.
Field solve_laplacian(Squares const& squares, Field const& delta) {
  Field psi = squares.zeros(), left = delta;
  for (double& l : left) l = -l;
  Field direction = left;
  double left2 = dot(left, left);
  double const enough = 1e-6 * left2;
  while (left2 > enough) {
    Field const image = squares.minus_laplacian(direction);
    double const length = left2 / dot(direction, image);
    for (std::size_t k = 0; k < psi.size(); ++k) {
      psi[k] += length * direction[k];
      left[k] -= length * image[k];
    }
    double const before = left2;
    left2 = dot(left, left);
    for (std::size_t k = 0; k < psi.size(); ++k)
      direction[k] = left[k] + left2 / before * direction[k];
  }
  return psi;
}

/// x in [0, length).
double wrapped(double x, double length) {
  double const rest = x - length * std::floor(x / length);
  return rest < length ? rest : 0;
}

}  // namespace

void even_out(State& state) {
  Squares const squares(state);
  auto const shift = squares.gradient(solve_laplacian(squares, relative_density(state, squares)));
  for (auto& position : state.position) {
    std::array<double, 2> moved = position;
    squares.around(position, [&](std::size_t square, double share) {
      moved[0] += share * shift[0][square];
      moved[1] += share * shift[1][square];
    });
    position = {wrapped(moved[0], state.box_length), wrapped(moved[1], state.box_height())};
  }
}

}  // namespace bagnold
