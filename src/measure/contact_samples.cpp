// SPDX-License-Identifier: BSD-3-Clause
#include "src/measure/contact_samples.hpp"

#include <Eigen/Eigenvalues>
#include <iterator>
#include <limits>

namespace bagnold {

namespace {

using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

statistics::Samples table(std::string name, std::string description,
                          std::vector<std::string> columns, Rows const& rows) {
  return {std::move(name),
          std::move(description),
          std::move(columns),
          {rows.data(), rows.data() + rows.size()}};
}

/// Matrix from (V_T, V_R, V_N) to the reported columns.
Rows columns_of(bool rotates) {
  Rows of(rotates ? 4 : 2, 3);
  if (rotates)
    of << 1, 0, 0,  // V_T
        0, 1, 0,    // V_R
        1, 1, 0,    // V_C_T
        0, 0, 1;    // V_N
  else
    of << 1, 0, 0, 0, 0, 1;
  return of;
}

/// Principal axes of each two columns, a row each: the two columns, their means, and the two
/// eigenvalues of their covariance, the larger one first, each with its unit vector.
Rows axes_of(Rows const& mean, Rows const& covariance) {
  auto const n = covariance.rows();
  Rows axes(n * (n - 1) / 2, 10);
  Eigen::Index row = 0;
  for (Eigen::Index x = 0; x < n; ++x)
    for (Eigen::Index y = x + 1; y < n; ++y, ++row) {
      Eigen::Matrix2d pair;
      pair << covariance(x, x), covariance(x, y), covariance(y, x), covariance(y, y);
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> const found(pair);
      auto const& value = found.eigenvalues();
      auto const& vector = found.eigenvectors();
      axes.row(row) << static_cast<double>(x), static_cast<double>(y), mean(0, x), mean(0, y),
          value(1), vector(0, 1), vector(1, 1), value(0), vector(0, 0), vector(1, 0);
    }
  return axes;
}

}  // namespace

void ContactSamples::add(ContactPick const& pick) {
  kept_.emplace(pick.rank, pick.velocities);
  if (kept_.size() > most) kept_.erase(std::prev(kept_.end()));
}

void ContactSamples::add(ContactSamples const& other) {
  for (auto const& [rank, velocities] : other.kept_) add({rank, velocities});
}

Real ContactSamples::limit() const {
  return kept_.size() < most ? std::numeric_limits<Real>::infinity() : kept_.rbegin()->first;
}

std::vector<double> ContactSamples::numbers() const {
  std::vector<double> to;
  for (auto const& [rank, v] : kept_)
    to.insert(to.end(), {rank, v.tangential, v.rotational, v.normal});
  return to;
}

void ContactSamples::restore(std::vector<double> const& numbers) {
  kept_.clear();
  for (std::size_t k = 0; k + 3 < numbers.size(); k += 4)
    kept_.emplace_hint(kept_.end(), numbers[k],
                       ContactVelocities{numbers[k + 1], numbers[k + 2], numbers[k + 3]});
}

std::vector<ContactVelocities> ContactSamples::velocities() const {
  std::vector<ContactVelocities> all;
  for (auto const& [rank, velocities] : kept_) all.push_back(velocities);
  return all;
}

ContactMotion sums_of(std::vector<ContactVelocities> const& velocities) {
  ContactMotion sums;
  for (auto const& v : velocities) sums.add(1, {1, 0}, {-v.normal, -v.tangential}, v.rotational);
  return sums;
}

std::vector<statistics::Samples> VelocityTables::operator()(
    std::vector<ContactVelocities> const& velocities, ContactMotion const& sums) const {
  if (velocities.size() < 2) return {};
  Rows const to = columns_of(rotates);
  Rows each(static_cast<Eigen::Index>(velocities.size()), 3);
  Eigen::Index row = 0;
  for (auto const& v : velocities) each.row(row++) << v.tangential, v.rotational, v.normal;

  using M = ContactMotion;
  auto const of = [&](int column) { return sums.value[column] / sums.value[M::contacts]; };
  Rows mean(1, 3), second(3, 3);
  mean << of(M::tangential), of(M::rotational), of(M::normal);
  second << of(M::tangential2), of(M::tangential_rotational), of(M::tangential_normal),
      of(M::tangential_rotational), of(M::rotational2), of(M::rotational_normal),
      of(M::tangential_normal), of(M::rotational_normal), of(M::normal2);
  Rows const means = mean * to.transpose();
  Rows const covariance = to * (second - mean.transpose() * mean) * to.transpose();

  std::vector<std::string> columns{"V_T [1]", "V_R [1]", "V_C_T [1]", "V_N [1]"};
  if (!rotates) columns = {"V_T [1]", "V_N [1]"};
  return {table(name, description, columns, each * to.transpose()),
          table(name + "_mean", "means of its columns", columns, means),
          table(name + "_covariance", "covariance of its columns, a row each", columns, covariance),
          table(name + "_axes",
                "principal axes of each two of its columns: variances along them, unit vectors",
                {"x [column]", "y [column]", "mean_x [1]", "mean_y [1]", "variance_1 [1]",
                 "x_1 [1]", "y_1 [1]", "variance_2 [1]", "x_2 [1]", "y_2 [1]"},
                axes_of(means, covariance))};
}

}  // namespace bagnold
