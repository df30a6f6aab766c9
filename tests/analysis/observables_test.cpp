// SPDX-License-Identifier: BSD-3-Clause
#include "src/measure/observables.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <set>
#include <string>

#include "kernels/physics/sums/sums.hpp"
#include "tests/config/scenes.hpp"

namespace bagnold {
namespace {

using C = SumColumns;
using Values = std::map<std::string, double>;

/// Averages over configurations as the papers write them: p_el[a][b] = <p_ab^el>, and so on.
struct Means {
  double p_el[2][2], p_dis[2][2], p_kin[2][2];  ///< [m / tau_e^2]
  double contacts;                              ///< of a disk
  double dvx2, vy2;                             ///< P2 Eqs. (35), (36)
  double dissipation;                           ///< of an area, [m / tau_e^3]
  double torque_power;                          ///< of an area, [m / tau_e^3]
  double spin, spin2;                           ///< thetadot/gammadot and its square, P2 Eq. (29)
};

Means random_means(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> some(-1e-4, 1e-4), positive(1e-6, 1e-4);
  Means m;
  for (auto* tensor : {&m.p_el, &m.p_dis, &m.p_kin})
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b) (*tensor)[a][b] = some(random);
  for (int a = 0; a < 2; ++a) {
    m.p_el[a][a] = 1e-3 + positive(random);
    m.p_kin[a][a] = positive(random);
  }
  m.p_el[1][0] = m.p_el[0][1];
  m.p_kin[1][0] = m.p_kin[0][1];  // P2's dissipative part is not symmetric
  m.contacts = 3.7;
  m.dvx2 = positive(random);
  m.vy2 = positive(random);
  m.dissipation = positive(random);
  m.torque_power = some(random);
  m.spin = -0.5 + some(random);
  m.spin2 = 0.7;
  return m;
}

/// The columns a simulation would have averaged.
std::vector<double> columns(Scene const& scene, double length, Means const& m) {
  std::vector<double> a(scene.rotates() ? C::count_rotating : C::count);
  double const area = length * length;
  double const n = static_cast<double>(scene.disks.count), rate = scene.shear.strain_rate;
  a[C::elastic_xx] = m.p_el[0][0] * area;
  a[C::elastic_xy] = m.p_el[0][1] * area;
  a[C::elastic_yy] = m.p_el[1][1] * area;
  a[C::dissipative_xx] = m.p_dis[0][0] * area;
  a[C::dissipative_xy] = m.p_dis[0][1] * area;
  a[C::dissipative_yx] = m.p_dis[1][0] * area;
  a[C::dissipative_yy] = m.p_dis[1][1] * area;
  a[C::dissipation] = m.dissipation * area;
  a[C::kinetic_xx] = m.p_kin[0][0] * area;
  a[C::kinetic_xy] = m.p_kin[0][1] * area;
  a[C::kinetic_yy] = m.p_kin[1][1] * area;
  a[C::contacts] = m.contacts * n;
  a[C::velocity_x2] = m.dvx2 * n;
  a[C::velocity_y2] = m.vy2 * n;
  if (scene.rotates()) {
    a[C::spin] = m.spin * rate * n;
    a[C::spin2] = m.spin2 * rate * rate * n;
    a[C::torque_power] = m.torque_power * area;
  }
  return a;
}

/// Every NAME by the formulas of the papers, in units tau_e = m = d_s = 1 with k_d = 1/Q.
Values by_the_papers(Scene const& scene, double length, Means const& m) {
  double const rate = scene.shear.strain_rate;
  double const k_d = 1 / scene.disks.elasticity;  // P1 Eq. (6), P2 Eq. (9)
  double p[2][2];                                 // P1 Eq. (12), P2 Eq. (15)
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b) p[a][b] = m.p_el[a][b] + m.p_dis[a][b] + m.p_kin[a][b];
  Values v;
  v["p"] = 0.5 * (p[0][0] + p[1][1]);  // P1 Eq. (13), P2 Eq. (16)
  v["sigma"] = -p[0][1];
  struct Part {
    char const* name;
    double const (*tensor)[2];
  };
  for (Part const part : {Part{"_el", m.p_el}, Part{"_dis", m.p_dis}, Part{"_kin", m.p_kin}}) {
    v[std::string("p") + part.name] = 0.5 * (part.tensor[0][0] + part.tensor[1][1]);
    v[std::string("sigma") + part.name] = -part.tensor[0][1];
    v[std::string("delta_p") + part.name] = 0.5 * (part.tensor[0][0] - part.tensor[1][1]);
  }
  v["delta_p"] = 0.5 * (p[0][0] - p[1][1]);  // P1 Eq. (14)
  v["sigma_dev"] = std::sqrt(v["delta_p"] * v["delta_p"] + v["sigma"] * v["sigma"]);
  for (auto const* stress : {"p", "sigma"}) {
    for (auto const* part : {"", "_el", "_dis", "_kin"})  // P1 Eq. (16), P2 Eq. (19)
      v["B_" + std::string(stress) + part] = v[std::string(stress) + part] / (rate * rate);
    for (auto const* part : {"", "_el"})  // P2 Eq. (20)
      v["eta_" + std::string(stress) + part] = v[std::string(stress) + part] / (k_d * rate);
  }
  v["mu"] = v["sigma"] / v["p"];
  v["I"] = rate / std::sqrt(v["p"]);  // P1 Eq. (20)
  v["T_g"] =
      v["p_kin"] / (static_cast<double>(scene.disks.count) / (length * length));  // p_kin = n T_g
  v["Z"] = m.contacts;
  v["R_v"] = m.dvx2 / m.vy2;  // P2 Eq. (37)
  v["p_dis_share"] = v["p_dis"] / v["p"];
  v["energy_gap"] = (v["sigma"] * rate - m.dissipation) / (v["sigma"] * rate);
  if (scene.rotates()) {
    v["spin_mean"] = m.spin;
    v["spin_var"] = m.spin2 - m.spin * m.spin;  // P2 Eq. (28)
    v["torque_power"] = m.torque_power / (v["sigma"] * rate);
  }
  return v;
}

Scene scene_of(std::string const& model, double elasticity) {
  Scene scene = minimal_scene();
  scene.disks.model = model;
  scene.disks.elasticity = elasticity;
  scene.disks.count = 730;
  scene.shear.strain_rate = 3e-3;
  return scene;
}

TEST(Observables, AreTheFormulasOfThePapers) {
  for (auto const* model : {"CD", "CD_n", "CD_rot", "CD_nt"})
    for (double const elasticity : {0.3, 4.0}) {
      Scene const scene = scene_of(model, elasticity);
      double const length = scene.box_length();
      Means const means = random_means(7);
      auto const averages = columns(scene, length, means);
      Values expected = by_the_papers(scene, length, means);
      for (auto const& observable : observables(scene, length)) {
        std::string const name(observable.name);
        ASSERT_EQ(expected.count(name), 1u) << name;
        double const value = expected[name];
        EXPECT_NEAR(observable.value(averages), value, 1e-12 * std::abs(value)) << name;
        expected.erase(name);
      }
      EXPECT_TRUE(expected.empty()) << expected.begin()->first << " is not there";
    }
}

TEST(Observables, NamesAndOrderAreThoseOfTheContract) {
  std::vector<std::string> const names{
      "p",           "p_el",        "p_dis",     "p_kin",      "sigma",
      "sigma_el",    "sigma_dis",   "sigma_kin", "delta_p",    "delta_p_el",
      "delta_p_dis", "delta_p_kin", "sigma_dev", "B_p",        "B_p_el",
      "B_p_dis",     "B_p_kin",     "B_sigma",   "B_sigma_el", "B_sigma_dis",
      "B_sigma_kin", "eta_p",       "eta_p_el",  "eta_sigma",  "eta_sigma_el",
      "mu",          "I",           "T_g",       "Z",          "R_v",
      "energy_gap",  "p_dis_share", "spin_mean", "spin_var",   "torque_power"};
  for (auto const* model : {"CD", "CD_rot"}) {
    Scene const scene = scene_of(model, 1.0);
    auto expected = names;
    if (!scene.rotates()) expected.resize(names.size() - 3);
    std::vector<std::string> found;
    for (auto const& observable : observables(scene, 10.0)) {
      found.emplace_back(observable.name);
      EXPECT_FALSE(observable.meaning.empty()) << observable.name;
      EXPECT_FALSE(observable.unit.empty()) << observable.name;
    }
    EXPECT_EQ(found, expected);
  }
}

/// In model CD the dissipative force is not central: only f_x r_y makes sigma.
TEST(Observables, TheShearStressIsNotSymmetrised) {
  Scene const scene = scene_of("CD", 1.0);
  Means means = random_means(8);
  auto const all = observables(scene, 10.0);
  auto const before = columns(scene, 10.0, means);
  means.p_dis[1][0] += 1.0;
  auto const after = columns(scene, 10.0, means);
  ASSERT_NE(before, after);
  for (auto const& observable : all)
    EXPECT_EQ(observable.value(before), observable.value(after)) << observable.name;
}

/// Before anything touches: stresses and mu of 0/0 are NaN or 0, never an error.
TEST(Observables, AreUndefinedWithoutMotion) {
  Scene const scene = scene_of("CD_rot", 1.0);
  std::vector<double> const nothing(C::count_rotating, 0.0);
  for (auto const& observable : observables(scene, 10.0)) {
    double const value = observable.value(nothing);
    if (std::set<std::string_view>{"mu", "R_v", "energy_gap", "p_dis_share", "torque_power"}
            .contains(observable.name))
      EXPECT_TRUE(std::isnan(value)) << observable.name;
    else if (observable.name == "I")
      EXPECT_FALSE(std::isfinite(value));
    else
      EXPECT_EQ(value, 0.0) << observable.name;
  }
}

}  // namespace
}  // namespace bagnold
