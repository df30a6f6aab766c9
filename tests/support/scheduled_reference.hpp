// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "src/config/strain_rates.hpp"
#include "tests/reference/implicit.hpp"
#include "tests/reference/two_stage.hpp"
#include "tests/support/simulations.hpp"

namespace bagnold::test {

/// A step of all pairs by a scheme, by its name. Power of its damping, and dissipative: out, sum
/// f_a r_b; not of the papers' scheme.
inline reference::StepPower reference_step(reference::System& system, std::string const& scheme,
                                           double (&dissipative)[2][2]) {
  if (is_implicit(scheme))
    return reference::implicit_step(
        system, reference::chebyshev_iterations(reference::rotates(system.p)), dissipative);
  if (scheme != papers_scheme) return reference::two_stage_step(system, dissipative);
  reference::step(system);
  return {};
}
inline void reference_step(reference::System& system, std::string const& scheme) {
  double dissipative[2][2];
  reference_step(system, scheme, dissipative);
}

/// All pairs, all images, through the strain rates of a scene. Where the rate changes, motions are
/// scaled with it (P2 Eqs. 40-41) or keep their excess over the mean flow, as the protocol has it.
class ScheduledReference {
 public:
  ScheduledReference(Scene const& scene, State const& start)
      : rates_(strain_rates(scene)),
        scheme_(scene.integration.scheme),
        system_(reference_parameters(scene), start) {
    system_.p.strain_rate = rates_.at(0).rate;
  }

  void step() {
    reference_step(system_, scheme_);
    auto const stretch = rates_.at(system_.step);
    if (stretch.begin == system_.step) change_rate(stretch.rate);
  }

  reference::System const& system() const { return system_; }

 private:
  void change_rate(double rate) {
    auto& p = system_.p;
    auto& velocity = system_.s.velocity;
    double const rise = rate - p.strain_rate, factor = rate / p.strain_rate;
    system_.initial_strain -= rise * p.time_step * static_cast<double>(system_.step);
    p.strain_rate = rate;
    if (rates_.scales_motions()) {
      for (auto& v : velocity) v = {factor * v[0], factor * v[1]};
      for (auto& one : system_.s.spin) one *= factor;
    } else {
      for (std::size_t i = 0; i < velocity.size(); ++i)
        velocity[i][0] += rise * system_.s.position[i][1];
      for (auto& one : system_.s.spin) one -= rise / 2;
    }
  }

  StrainRates rates_;
  std::string scheme_;
  reference::System system_;
};

}  // namespace bagnold::test
