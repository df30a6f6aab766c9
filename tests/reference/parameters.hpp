// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "src/state/state.hpp"

/// The oracle: all pairs, all images, one disk after another, written from the papers alone (P1 =
/// PRE 95, 012902 (2017), P2 = PRE 95, 052903 (2017)). Slow and plain on purpose: it shares no code
/// with kernels/, so that an agreement of the two means something.
namespace bagnold::reference {

/// What is simulated. Units: d_s, tau_e, and m (equal masses, P2) or m_0 (area masses, P1); k_e
/// = 1.
struct Parameters {
  enum class Model { CD, CD_n, CD_rot, CD_nt };
  Model model = Model::CD_n;
  double elasticity = 1.0;          ///< Q; k_d = 1 / Q (P1 Eq. 6, P2 Eq. 9)
  double damping_normal = 1.0;      ///< model CD_nt: k_d^(n) Q
  double damping_tangential = 1.0;  ///< model CD_nt: k_d^(t) Q
  double force_exponent = 2.0;      ///< alpha (P1 Eq. 1)
  bool area_mass = false;           ///< false: m_i = m = 1 (P2); true: by area, m_0 = 1 (P1)
  double strain_rate = 0.0;         ///< [1 / tau_e]
  double time_step = 0.05;          ///< [tau_e]
  double drag = 0.0;                ///< zeta, [m / tau_e]; P2 Sec. IV
  /// Force and torque on a disk beside it, in a step: [m d_s / tau_e^2], [m d_s^2 / tau_e^2].
  std::function<std::array<double, 3>(std::size_t disk, long step)> push;
};

/// What the oracle has no formula of, by its name in the input: it refuses to be compared with it.
struct NoFormula : std::invalid_argument {
  NoFormula(char const* what, std::string_view name)
      : std::invalid_argument("the all-pairs reference has no formula of the " + std::string(what) +
                              " \"" + std::string(name) +
                              "\"; write it in tests/reference, from its paper") {}
};

/// Constants of a law f_dis = -k_n (v . n) n - k_t [v - (v . n) n], [m / tau_e]; v at the point of
/// contact where disks rotate.
struct LinearLaw {
  bool rotates;
  double normal, tangential;
};

/// Takes the law of that name: one of the papers, or else its constants, if it has them and they
/// make one of the papers' forms. Throws NoFormula.
inline void set_law(Parameters& p, std::string_view name, std::optional<LinearLaw> const& law) {
  using Model = Parameters::Model;
  constexpr std::pair<std::string_view, Model> of_papers[] = {
      {"CD", Model::CD}, {"CD_n", Model::CD_n}, {"CD_rot", Model::CD_rot}, {"CD_nt", Model::CD_nt}};
  for (auto const& [known, model] : of_papers) {
    p.model = model;
    if (known == name) return;
  }
  if (!law) throw NoFormula("law", name);
  if (law->rotates) {
    p.model = Model::CD_nt;
    p.damping_normal = law->normal * p.elasticity;
    p.damping_tangential = law->tangential * p.elasticity;
  } else if (law->normal > 0.0 && (law->tangential == 0.0 || law->tangential == law->normal)) {
    p.model = law->tangential == 0.0 ? Model::CD_n : Model::CD;
    p.elasticity = 1.0 / law->normal;
  } else {
    throw NoFormula("law", name);
  }
}

/// Whether disks carry spins: only where the law reads them.
inline bool rotates(Parameters const& p) {
  return p.model == Parameters::Model::CD_rot || p.model == Parameters::Model::CD_nt;
}

/// m_i. By area: m_i = rho_0 pi (d_i/2)^2 with m_0 = rho_0 d_s^2 / 2 = 1 (P1, below Eq. 4), so that
/// m_i = (pi / 2) d_i^2; pi/2 for a small disk.
inline double mass(Parameters const& p, double diameter) {
  double const pi = 3.14159265358979323846;
  return p.area_mass ? pi / 2.0 * diameter * diameter : 1.0;
}

/// I_i = m_i (d_i/2)^2 / 2, [m d_s^2] (P2, below Eq. 7).
inline double moment_of_inertia(Parameters const& p, double diameter) {
  double const radius = diameter / 2.0;
  return 0.5 * mass(p, diameter) * radius * radius;
}

}  // namespace bagnold::reference
