// SPDX-License-Identifier: BSD-3-Clause
#include "src/measure/contact_samples.hpp"

#include <Eigen/Eigenvalues>
#include <iterator>

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

/// Of each two columns: which they are, their means, and the two eigenvalues of their covariance,
/// the larger one first, each with its unit vector.
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

void ContactSamples::add(OpenContact const& contact) {
  keep(choice_.rank(contact.a, contact.b, contact.begin), contact.velocities);
}

void ContactSamples::keep(double rank, ContactVelocities const& velocities) {
  kept_.emplace(rank, velocities);
  if (kept_.size() > most) kept_.erase(std::prev(kept_.end()));
}

void ContactSamples::add(ContactSamples const& other) {
  for (auto const& [rank, velocities] : other.kept_) keep(rank, velocities);
}

void ContactSamples::save(Numbers& numbers) const {
  auto& to = numbers["contacts_samples"];
  for (auto const& [rank, v] : kept_)
    to.insert(to.end(), {rank, v.tangential, v.rotational, v.normal});
}

void ContactSamples::load(Numbers const& numbers) {
  auto const& from = numbers.at("contacts_samples");
  kept_.clear();
  for (std::size_t k = 0; k + 3 < from.size(); k += 4)
    kept_.emplace_hint(kept_.end(), from[k],
                       ContactVelocities{from[k + 1], from[k + 2], from[k + 3]});
}

std::vector<statistics::Samples> ContactSamples::samples() const {
  if (kept_.size() < 2) return {};
  std::vector<std::string> columns{"V_T [1]", "V_R [1]", "V_C_T [1]", "V_N [1]"};
  if (!rotates_) columns = {"V_T [1]", "V_N [1]"};
  Rows rows(static_cast<Eigen::Index>(kept_.size()), static_cast<Eigen::Index>(columns.size()));
  Eigen::Index row = 0;
  for (auto const& [rank, v] : kept_) {
    if (rotates_)
      rows.row(row++) << v.tangential, v.rotational, v.at_contact(), v.normal;
    else
      rows.row(row++) << v.tangential, v.normal;
  }
  Rows const mean = rows.colwise().mean();
  Rows const off = rows.rowwise() - mean.row(0);
  Rows const covariance = off.transpose() * off / static_cast<double>(rows.rows() - 1);
  return {table("contact_velocities",
                "relative velocities over gammadot d_s (P2 Eqs. 30-34), each of one collision at a "
                "random step of it",
                columns, rows),
          table("contact_velocities_mean", "means of its columns", columns, mean),
          table("contact_velocities_covariance", "covariance of its columns, a row each", columns,
                covariance),
          table("contact_velocities_axes",
                "principal axes of each two of its columns: variances along them, unit vectors",
                {"x [column]", "y [column]", "mean_x [1]", "mean_y [1]", "variance_1 [1]",
                 "x_1 [1]", "y_1 [1]", "variance_2 [1]", "x_2 [1]", "y_2 [1]"},
                axes_of(mean, covariance))};
}

}  // namespace bagnold
