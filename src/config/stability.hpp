// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "src/config/scene.hpp"
#include "src/config/schemes.hpp"

namespace bagnold {

/// Spectral radius of one step for two small disks, the lightest pair, held in contact: the larger
/// one of the normal and the tangential motion. Above 1 the step creates energy.
///
/// Normal: mu x'' = -k x - k_n x' with k = 1/d^2 (not harmonic: the stiffness at 20% overlap).
/// Tangential: mu_t u' = -k_t u, with 1/mu_t = 2/m, and 4/m more where the disks can roll.
double contact_spectral_radius(Scene const& scene, std::string_view scheme, double time_step);

/// Spectral radius for the scheme of the scene.
double contact_spectral_radius(Scene const& scene, double time_step);

/// Largest time step at which no motion grows in any network of contacts with at most six contacts
/// a disk, for damping alone and for the elastic force alone, [tau_e]. Sufficient, not necessary.
///
/// A disk cut into six parts has six contacts, one for each part: rates of damping are at most 6
/// k_d/mu, squared frequencies 6 k/mu. Each scheme states the largest values that it can step.
double largest_stable_time_step(Scene const& scene, std::string_view scheme);

/// Time step up to which the damping of a dense flow was not seen to grow, [tau_e]; measured.
///
/// The contacts of a steady state of CD_rot at phi = 0.82 (Z = 3.5), held as they are, relax at
/// rates up to that of ContactRates::dense_flow, m of small disks. The elastic
/// force is left out. At larger steps some contacts of such a flow grow; at phi = 0.84 the limit is
/// 4% lower.
double dense_flow_time_step(Scene const& scene, std::string_view scheme);

}  // namespace bagnold
