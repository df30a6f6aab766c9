// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/config/scene.hpp"

namespace bagnold {

/// The papers' time steps, [tau_e].
///
/// CD_n and general: min{0.5/Q, 0.1, 0.2 Q} (P1 Sec. II C). CD and CD_rot: 0.05, and below Q = 0.5
/// max(0.01, 0.1 Q), after P2 Sec. II D, which says "down to 0.01".
double paper_time_step(Scene::Disks const& disks);

/// The time step of a scene: as given, or the papers', of a ramp shortened to divide ramp_every.
double time_step(Scene const& scene);

/// Spectral radius of one step of the modified velocity Verlet scheme (P2 Eqs. 21-24) for two small
/// disks, the lightest pair, held in contact: the larger one of the normal and the tangential
/// motion. Above 1 the step makes energy.
///
/// Normal: mu x'' = -k x - k_n x' with k = 1/d^2 (for alpha = 5/2 the stiffness at 20% overlap).
/// Tangential: mu_t u' = -k_t u, with 1/mu_t = 2/m, and 4/m more where the disks can roll.
double contact_spectral_radius(Scene const& scene, double time_step);

}  // namespace bagnold
