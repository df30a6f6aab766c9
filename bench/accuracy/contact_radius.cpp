// SPDX-License-Identifier: BSD-3-Clause
#include "bench/accuracy/contact_radius.hpp"

#define EIGEN_DONT_VECTORIZE  // GCC 12 warns about its own AVX-512 header
#include <Eigen/Dense>
#include <cmath>

#include "bench/accuracy/damped_contact.hpp"
#include "kernels/physics/schemes/two_stage_leapfrog.hpp"
#include "src/config/errors.hpp"

namespace bagnold::accuracy {

namespace {

using Matrix = Eigen::Matrix2d;  ///< on (x, v): x'' = -k x - c v

double radius(Matrix const& m) { return m.eigenvalues().cwiseAbs().maxCoeff(); }

Matrix drift(double h) { return (Matrix() << 1, h, 0, 1).finished(); }

/// v <- e v - f x, then x <- x + h v.
Matrix kick_and_fly(double e, double f, double h) {
  return drift(h) * (Matrix() << 1, 0, -f, e).finished();
}

Matrix papers(double k, double c, double h) {
  Matrix const rate = (Matrix() << 0, 1, -k, -c).finished();
  Matrix const one = Matrix::Identity();
  Matrix const trial = one + h * rate;
  Matrix step = one;
  step.row(1) += h / 2 * (rate.row(1) * (one + trial));
  step.row(0) += h / 2 * (one.row(1) + step.row(1));
  return step;
}

/// On (x, v, f_0), f_0 the force felt last.
double groot_warren(double k, double c, double h, double lambda) {
  Eigen::Matrix3d step;
  Eigen::RowVector3d const x(1, h, h * h / 2);
  Eigen::RowVector3d const felt(0, 1, lambda * h);
  Eigen::RowVector3d const force = -k * x - c * felt;
  step.row(0) = x;
  step.row(1) = Eigen::RowVector3d(0, 1, h / 2) + h / 2 * force;
  step.row(2) = force;
  return step.eigenvalues().cwiseAbs().maxCoeff();
}

}  // namespace

ContactRadius contact_radius(Scene const& scene, std::string const& scheme, double h) {
  DampedContact const exact(scene);
  double const c = 2 * exact.decay, k = exact.frequency2 + exact.decay * exact.decay;
  double const s = exact.sliding;
  double const z = c * h, y = s * h;
  auto const held = [](double t) { return t > 0 ? -std::expm1(-t) / t : 1.0; };
  if (scheme == "modified-velocity-verlet")
    return {radius(papers(k, c, h)), std::abs(1 - y + y * y / 2)};
  if (scheme == "lagged-velocity-verlet")
    return {radius(kick_and_fly(1 - z, h * k, h)), std::abs(1 - y)};
  if (scheme == "groot-warren") return {groot_warren(k, c, h, 0.65), groot_warren(0, s, h, 0.65)};
  if (scheme == "implicit-verlet")
    return {radius(kick_and_fly((1 - z / 2) / (1 + z / 2), h * k / (1 + z / 2), h)),
            std::abs(1 - y / 2) / (1 + y / 2)};
  if (scheme == "pairwise-sweep")
    return {radius(kick_and_fly(std::exp(-z), h * k * (1 + std::exp(-z)) / 2, h)), std::exp(-y)};
  if (scheme == "increment-sweep")
    return {radius(kick_and_fly(std::exp(-z), h * k * held(z), h)), std::exp(-y)};
  if (scheme == "two-stage") {
    double const a = TwoStageLeapfrog::share(z), b = TwoStageLeapfrog::share(y);
    return {radius(kick_and_fly(1 - z + a * z * z, h * k * (1 - a * z), h)),
            std::abs(1 - y + b * y * y)};
  }
  throw InputError("no matrix is known of the scheme " + scheme);
}

}  // namespace bagnold::accuracy
