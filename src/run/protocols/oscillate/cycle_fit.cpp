// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/protocols/oscillate/cycle_fit.hpp"

#include <Eigen/Dense>

namespace bagnold {

namespace {

Eigen::MatrixXd matrix_of(std::vector<std::vector<double>> const& rows) {
  Eigen::MatrixXd matrix(rows.size(), rows.front().size());
  for (std::size_t k = 0; k < rows.size(); ++k)
    matrix.row(static_cast<Eigen::Index>(k)) = Eigen::Map<Eigen::RowVectorXd const>(
        rows[k].data(), static_cast<Eigen::Index>(rows[k].size()));
  return matrix;
}

}  // namespace

struct CycleFit::Solvers {
  Eigen::MatrixXd terms;
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> all, without_drift;

  explicit Solvers(Eigen::MatrixXd const& of)
      : terms(of),
        all(of.colPivHouseholderQr()),
        without_drift(of.leftCols(of.cols() - 1).colPivHouseholderQr()) {}
};

CycleFit::CycleFit(std::vector<std::vector<double>> const& terms)
    : solvers_(std::make_unique<Solvers>(matrix_of(terms))) {}

CycleFit::~CycleFit() = default;

std::vector<double> CycleFit::operator()(std::span<double const> cycle,
                                         std::optional<double> drift) const {
  auto const& [terms, all, without_drift] = *solvers_;
  Eigen::Map<Eigen::VectorXd const> const stress(cycle.data(),
                                                 static_cast<Eigen::Index>(cycle.size()));
  auto const last = terms.cols() - 1;
  Eigen::VectorXd const of =
      drift ? Eigen::VectorXd(without_drift.solve(stress - *drift * terms.col(last)))
            : Eigen::VectorXd(all.solve(stress));
  std::vector<double> found(of.data() + 1, of.data() + of.size());
  if (drift) found.push_back(*drift);
  return found;
}

}  // namespace bagnold
