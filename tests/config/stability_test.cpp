// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/stability.hpp"

#include <gtest/gtest.h>

#define EIGEN_DONT_VECTORIZE  // GCC 12 warns about its own AVX-512 header
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <fstream>
#include <numbers>
#include <sstream>

#include "src/config/contact_rates.hpp"
#include "src/config/time_step.hpp"
#include "tests/config/scenes.hpp"
#include "tests/support/schemes.hpp"

namespace bagnold {
namespace {

/// Two small disks in a contact that lasts, along x at distance d_s: the motion to first order.
///
/// (x_i, x_j, y_i, y_j; their velocities, spin_i, spin_j). Forces of P1 and P2 Eqs. (2), (3), (5)
/// and torques of P2 Eq. (7), disk i at the left: n = (-1, 0), s_ji = (1/2, 0), s_ij = (-1/2, 0).
/// Takes nothing from the code under test.
struct TwoDisks {
  using Vector = Eigen::Matrix<double, 10, 1>;
  double mass, stiffness, damping_normal, damping_tangential;
  bool rotate;

  explicit TwoDisks(Scene::Disks const& d) {
    mass = d.mass == "area" ? std::numbers::pi / 2 : 1.0;
    // second derivative of (1/alpha) (1 - r/d)^alpha, at 20% overlap
    stiffness = d.force_exponent == 2.0 ? 1.0 : 1.5 * std::sqrt(0.2);
    double const k_d = 1 / d.elasticity;
    bool const general = d.model == "CD_nt";
    damping_normal = general ? d.damping_normal * k_d : k_d;
    damping_tangential = general ? d.damping_tangential * k_d : d.model == "CD_n" ? 0.0 : k_d;
    rotate = general || d.model == "CD_rot";
  }

  /// d/dt of the velocities and spins.
  Vector acceleration(Vector const& q) const {
    double const vx = q[4] - q[5];
    double vy = q[6] - q[7];                    // of the points of contact:
    if (rotate) vy += q[8] * 0.5 + q[9] * 0.5;  // spin x s_ji - spin x s_ij
    double const fx = -stiffness * (q[0] - q[1]) - damping_normal * vx;
    double const fy = -damping_tangential * vy;
    double const inertia = mass / 8;  // m (d/2)^2 / 2
    Vector a = Vector::Zero();
    a[4] = fx / mass;
    a[5] = -fx / mass;
    a[6] = fy / mass;
    a[7] = -fy / mass;
    if (rotate) {
      a[8] = 0.5 * fy / inertia;    // s_ji x f_ij
      a[9] = -0.5 * -fy / inertia;  // s_ij x f_ji
    }
    return a;
  }

  /// P2 Eqs. (21)-(24).
  Vector step(Vector const& q0, double dt) const {
    Vector const a0 = acceleration(q0);
    Vector trial = q0 + dt * a0;                                                   // (21)
    trial.head<4>() = q0.head<4>() + dt * q0.segment<4>(4);                        // (22)
    Vector q1 = q0 + dt / 2 * (a0 + acceleration(trial));                          // (23)
    q1.head<4>() = q0.head<4>() + dt / 2 * (q0.segment<4>(4) + q1.segment<4>(4));  // (24)
    return q1;
  }

  /// Leapfrog with a second stage of the damping of the change, as docs/accuracy.md has it:
  /// impulses of the first stage times a share, along and across the contact.
  Vector two_stage(Vector const& q0, double dt) const {
    Vector const change = dt * acceleration(q0);
    TwoDisks without = *this;
    without.stiffness = 0;
    Vector felt = Vector::Zero();
    felt.tail<6>() = change.tail<6>();
    Vector second = dt * without.acceleration(felt);
    auto const share = [](double z) {
      return std::max(1.0 / 7, z < 1e-4 ? 0.5 : 1 / z - (1 - std::exp(-z)) / (z * z));
    };
    double const inverse = 2 / mass;
    second.segment<2>(4) *= share(damping_normal * dt * inverse);
    second.tail<4>() *= share(damping_tangential * dt * inverse * (rotate ? 3 : 1));
    Vector q1 = q0 + change + second;
    q1.head<4>() = q0.head<4>() + dt * q1.segment<4>(4);
    return q1;
  }

  Vector step(Vector const& q0, double dt, std::string_view scheme) const {
    return scheme == two_stage_scheme ? two_stage(q0, dt) : step(q0, dt);
  }

  /// Largest |eigenvalue| of a step, without the motion that a contact does not see: both disks
  /// together (2), the places along y (2), and the two of four velocities along y and spins that
  /// leave the points of contact at rest, and the spin that no force changes (3 in all).
  double radius(double dt, std::string_view scheme) const {
    Eigen::Matrix<double, 10, 10> matrix;
    for (int k = 0; k < 10; ++k) matrix.col(k) = step(Vector::Unit(k), dt, scheme);
    Eigen::Matrix<std::complex<double>, 10, 1> values = matrix.eigenvalues();
    std::sort(values.data(), values.data() + 10,
              [](auto a, auto b) { return std::abs(a - 1.0) < std::abs(b - 1.0); });
    return values.tail<3>().cwiseAbs().maxCoeff();
  }
};

std::vector<Scene::Disks> all_disks() {
  std::vector<Scene::Disks> all;
  for (auto const* mass : {"equal", "area"})
    for (auto const* model : {"CD", "CD_n", "CD_rot", "CD_nt", "CD_nt"})
      for (double const alpha : {2.0, 2.5})
        for (double const q : {0.05, 0.3, 0.5, 1.0, 2.0, 10.0, 100.0}) {
          Scene::Disks d = disks(model, q, mass);
          d.force_exponent = alpha;
          if (d.model == "CD_nt") {  // mostly normal, then mostly tangential
            bool const second =
                !all.empty() && all.back().model == "CD_nt" && all.back().damping_normal < 1;
            d.damping_normal = second ? 0.3 : 1.7;
            d.damping_tangential = second ? 2.1 : 0.4;
          }
          all.push_back(d);
        }
  return all;
}

constexpr double steps_of_time[] = {0.003, 0.01, 0.05, 0.1, 0.17, 0.33, 0.5, 0.8,
                                    1.1,   1.37, 1.6,  2.0, 2.5,  3.1,  5.0};

TEST(ContactSpectralRadius, IsThatOfTheSchemesMatrix) {
  for (auto const scheme : {papers_scheme, two_stage_scheme})
    for (auto const& d : all_disks())
      for (double const dt : steps_of_time) {
        Scene scene;
        scene.disks = d;
        double const expected = TwoDisks(d).radius(dt, scheme);
        EXPECT_NEAR(contact_spectral_radius(scene, scheme, dt) / expected, 1.0, 1e-6)
            << scheme << " " << d.model << " " << d.mass << " alpha = " << d.force_exponent
            << " Q = " << d.elasticity << " dt = " << dt;
      }
}

/// Simulated step by step: what the contact feels (the distance, and the velocity of the points of
/// contact) grows exactly where the radius is above 1.
TEST(ContactSpectralRadius, IsAboveOneWhereAContactGrows) {
  int grown = 0, shrunk = 0;
  for (auto const scheme : {papers_scheme, two_stage_scheme})
    for (auto const& d : all_disks())
      for (double const dt : steps_of_time) {
        Scene scene;
        scene.disks = d;
        double const radius = contact_spectral_radius(scene, scheme, dt);
        if (std::abs(radius - 1) < 0.01) continue;
        TwoDisks const two(d);
        auto const felt = [&](TwoDisks::Vector const& q) {
          double const sliding = q[6] - q[7] + (two.rotate ? (q[8] + q[9]) / 2 : 0.0);
          double const damped = d.model == "CD_n" ? 0.0 : sliding;
          return std::hypot(q[0] - q[1], q[4] - q[5], damped);
        };
        TwoDisks::Vector q = TwoDisks::Vector::Zero();
        q[4] = 0.3;
        q[6] = 0.2;
        double const before = felt(q);
        for (int k = 0; k < 3000 && felt(q) < 1e100 && felt(q) > 1e-100; ++k)
          q = two.step(q, dt, scheme);
        EXPECT_EQ(felt(q) > before, radius > 1)
            << d.model << " " << d.mass << " Q = " << d.elasticity << " dt = " << dt
            << " radius = " << radius;
        ++(felt(q) > before ? grown : shrunk);
      }
  EXPECT_GT(grown, 100);
  EXPECT_GT(shrunk, 100);
}

/// CD_nt with equal constants is CD_rot (P2, below Eq. 7); without tangential damping it is CD_n.
TEST(ContactSpectralRadius, GeneralEndsInTheOthers) {
  for (double const q : {0.1, 1.0, 30.0})
    for (double const dt : steps_of_time) {
      Scene rolling, general;
      rolling.disks = disks("CD_rot", q);
      general.disks = disks("CD_nt", q);
      EXPECT_EQ(contact_spectral_radius(general, dt), contact_spectral_radius(rolling, dt));
      rolling.disks.model = "CD_n";
      general.disks.damping_tangential = 0;
      EXPECT_EQ(contact_spectral_radius(general, dt), contact_spectral_radius(rolling, dt));
    }
}

/// Damping of a disk held by six others in a ring, all alike and free: the step said to be stable
/// does not grow, twice of it does.
TEST(LargestStableTimeStep, HoldsForASevenDiskFlower) {
  for (auto const scheme : {papers_scheme, two_stage_scheme})
    for (double const q : {0.1, 1.0}) {
      Scene scene;
      scene.disks = disks("CD", q);
      // Centre 0 touches 1..6, which touch their neighbours: relative velocities, one component.
      Eigen::Matrix<double, 7, 7> contacts = Eigen::Matrix<double, 7, 7>::Zero();
      auto const join = [&](int a, int b) {
        contacts(a, a) += 1;
        contacts(b, b) += 1;
        contacts(a, b) -= 1;
        contacts(b, a) -= 1;
      };
      for (int k = 1; k <= 6; ++k) {
        join(0, k);
        join(k, k % 6 + 1);
      }
      double const largest = contacts.eigenvalues().real().maxCoeff() / q;  // rate, unit masses
      double const dt = largest_stable_time_step(scene, scheme);
      auto const factor = [&](double step) {
        double const y = largest * step;
        double const share = scheme == two_stage_scheme ? 1.0 / 7 : 0.5;
        return std::abs(1 - y + share * y * y);
      };
      EXPECT_LE(factor(dt), 1.0) << scheme << " Q = " << q;
      EXPECT_GT(factor(2 * dt), 1.0) << scheme << " Q = " << q;
    }
}

/// A packing stepped by the schemes themselves: docs/data/accuracy/stability_packing.csv.
/// docs/stability.md: 18.8, 8.0 and 5.3 k_d/m; what CD_nt adds beyond its k_t is along the
/// normal.
TEST(ContactRates, OfDenseFlowsAreTheMeasuredOnes) {
  auto const rate = [](std::string const& model, double k_n, double k_t) {
    Scene scene = minimal_scene();
    scene.disks.model = model;
    scene.disks.elasticity = 2;
    scene.disks.damping_normal = 2 * k_n;
    scene.disks.damping_tangential = 2 * k_t;
    return ContactRates(scene).dense_flow;
  };
  EXPECT_DOUBLE_EQ(rate("CD", 0.5, 0.5), 4.0);
  EXPECT_DOUBLE_EQ(rate("CD_n", 0.5, 0.5), 2.65);
  EXPECT_DOUBLE_EQ(rate("CD_rot", 0.5, 0.5), 9.4);
  EXPECT_DOUBLE_EQ(rate("CD_nt", 0.5, 0.5), 9.4);
  EXPECT_DOUBLE_EQ(rate("CD_nt", 0.5, 0.0), 2.65);
  EXPECT_DOUBLE_EQ(rate("CD_nt", 0.3, 0.5), 9.4);
}

TEST(DenseFlowTimeStep, IsTheMeasuredOne) {
  std::ifstream file(source_folder / "docs/data/accuracy/stability_packing.csv");
  int rows = 0;
  for (std::string line; std::getline(file, line);) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream row(line);
    std::string model, mass, fraction, scheme, arrangement;
    double measured = 0;
    row >> model >> mass >> fraction >> scheme >> arrangement >> measured;
    if (arrangement != "index") continue;
    if (scheme != papers_scheme && scheme != "two-stage") continue;
    Scene scene;
    scene.disks = disks(model, 0.25, mass);
    auto const name = scheme == papers_scheme ? papers_scheme : two_stage_scheme;
    EXPECT_NEAR(dense_flow_time_step(scene, name) / 0.25, measured, 0.01 * measured) << line;
    ++rows;
  }
  EXPECT_EQ(rows, 6);
}

TEST(DenseFlowTimeStep, LiesBetweenSixContactsAndOne) {
  for (auto const* model : {"CD", "CD_n", "CD_rot", "CD_nt"})
    for (auto const* mass : {"equal", "area"})
      for (auto const scheme : {papers_scheme, two_stage_scheme}) {
        Scene scene;
        scene.disks = disks(model, 0.1, mass);
        double const dt = dense_flow_time_step(scene, scheme);
        EXPECT_GT(dt, largest_stable_time_step(scene, scheme)) << model;
        EXPECT_LE(contact_spectral_radius(scene, scheme, dt), 1) << model;
      }
}

TEST(DenseFlowTimeStep, OfGeneralEndsInTheOthers) {
  Scene general, law;
  general.disks = disks("CD_nt", 0.5);
  law.disks = disks("CD_rot", 0.5);
  auto const of = [](Scene const& scene) { return dense_flow_time_step(scene, two_stage_scheme); };
  EXPECT_DOUBLE_EQ(of(general), of(law));
  general.disks.damping_tangential = 0;
  law.disks.model = "CD_n";
  EXPECT_DOUBLE_EQ(of(general), of(law));
  general.disks.damping_tangential = 0.5;
  EXPECT_LT(of(general), of(law));
}

/// No rule warns of itself where dampings are those of the papers' figures.
TEST(DenseFlowTimeStep, BearsTheRules) {
  for (auto const* model : {"CD", "CD_n", "CD_rot", "CD_nt"})
    for (double const q : {0.1, 0.3, 0.5, 1.0, 50.0, 500.0}) {
      Scene scene;
      scene.disks = disks(model, q, "equal");
      EXPECT_GT(dense_flow_time_step(scene, two_stage_scheme),
                rule_time_step(scene, two_stage_scheme));
      if (scene.disks.model != "CD_nt") {
        EXPECT_GT(dense_flow_time_step(scene, papers_scheme), paper_time_step(scene.disks)) << q;
      }
    }
}

TEST(LargestStableTimeStep, ScalesWithQWhereDampingLimits) {
  for (auto const* model : {"CD", "CD_n", "CD_rot", "CD_nt"})
    for (auto const scheme : {papers_scheme, two_stage_scheme}) {
      Scene one, half;
      one.disks = disks(model, 0.1);
      half.disks = disks(model, 0.05);
      EXPECT_NEAR(largest_stable_time_step(one, scheme) / largest_stable_time_step(half, scheme),
                  2.0, 1e-9)
          << model;
    }
  Scene rolling;
  rolling.disks = disks("CD_rot", 1.0);
  EXPECT_NEAR(largest_stable_time_step(rolling, two_stage_scheme), 7.0 / 36, 1e-12);
  EXPECT_NEAR(largest_stable_time_step(rolling, papers_scheme), 2.0 / 36, 1e-12);
}

}  // namespace
}  // namespace bagnold
