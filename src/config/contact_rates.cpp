// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/contact_rates.hpp"

#include <algorithm>

#include "kernels/physics/repulsion/repulsion.hpp"
#include "kernels/physics/species.hpp"
#include "src/config/laws.hpp"

namespace bagnold {

namespace {

/// Fastest relaxation rate of the contacts of a dense flow, held as they are, over k/m of small
/// disks. Measured in a steady state of CD_rot at phi = 0.82 (Z = 3.5), see docs/stability.md.
constexpr double rolling = 18.8;      ///< disks that roll, k_t = k_n
constexpr double sliding = 8.0;       ///< disks that slide, k_t = k_n
constexpr double along_normal = 5.3;  ///< k_t = 0

/// The rate is convex in both constants, so at most that of k_t in both directions and of the rest
/// along the normal.
double dense_flow_rate(LawConstants const& k, bool rotates) {
  return (rotates ? rolling : sliding) * k.tangential +
         along_normal * std::max(k.normal - k.tangential, 0.0);
}

}  // namespace

double const ContactRates::network = along_normal / 2;

ContactRates::ContactRates(Scene const& scene) {
  double const small = make_species_table(scene.mass_by_area()).inverse_mass.small;
  with_repulsion(scene.disks.force_exponent, [&]<class Repulsion>(Repulsion) {
    stiffness = 2 * small * Repulsion::stiffness(largest_relative_overlap);
    harmonic = Repulsion::force_exponent == 2;
  });
  auto const& law = law_of(scene.disks);
  auto const constants = law.constants(scene.disks);
  normal = 2 * small * constants.normal;
  tangential = 2 * small * tangential_mobility(law.rotates) * constants.tangential;
  dense_flow = small * dense_flow_rate(constants, law.rotates);
}

}  // namespace bagnold
