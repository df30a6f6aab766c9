// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "src/run/warnings/warning.hpp"

/// Each looks at one thing that may be wrong with a result, in a file of its own, and warns or not.
/// What they go by, and why, is in docs/stability.md.
namespace bagnold {

using Check = std::optional<Warning>(FinishedRun const&);

/// Standard errors beyond which a deviation is no accident: of Gaussian noise in less than 1 of
/// 10^4 cases.
inline constexpr double standard_errors = 4;

/// phi > phi_J: a yield stress is left as the rate vanishes, so that neither B nor eta has a limit.
Check above_jamming;

/// Disks so soft, at this rate, that B_p or eta_p of hard ones would be another.
Check hard_core_limit;

/// Contacts so deep that disks are no grains.
Check large_overlap;

/// Work is done on the disks that is neither dissipated nor kept: the time step is too coarse.
Check energy_balance;

/// Whole contacts have a dissipative pressure: the time step is too coarse for them.
Check dissipative_pressure;

/// Torques put energy into the rotation that it does not keep: the time step is too coarse.
Check rotation_balance;

/// A time step with which a collision loses another energy than it should.
Check collision_loss;

/// Implicit damping where the motion is not overdamped: inertia decides what flows, not damping.
Check implicit_inertia;

/// Quasi-static steps where energy is neither dissipated nor kept: inertia decides what flows.
Check quasi_static_inertia;

/// A time step that a single contact bears, but not the damping of a dense flow.
Check contact_network;

/// B_p or B_sigma drifts while it is measured.
Check steady_state;

/// B_p or B_sigma has no error, or replicas disagree by more than theirs.
Check error_bar;

/// So few collisions that the state cannot have forgotten its start.
Check few_collisions;

/// All disks move together on top of the shear flow, which p_kin counts as fluctuations.
Check net_momentum;

/// The motion is that of the whole box: bands, or a box too small.
Check box_size;

/// tau_dur without the long contacts: the run ended before they did, or none ended at all.
Check contact_durations;

/// All of them, in the order of the summary.
inline constexpr Check* all_checks[] = {
    above_jamming,        hard_core_limit,  large_overlap,  energy_balance,
    dissipative_pressure, rotation_balance, collision_loss, implicit_inertia,
    quasi_static_inertia, contact_network,  steady_state,   error_bar,
    few_collisions,       net_momentum,     box_size,       contact_durations};

/// "the mean motion against the shear flow, (-0.03, 0) d_s/tau_e, 97% of the kinetic energy"
std::string mean_motion_in_words(std::array<double, 2> const& velocity, double share);

/// The command that runs the scene with half its time step.
std::string half_the_step(FinishedRun const& finished);

/// Mean relative overlap of contacts, 1 - r_ij/d_ij, from elastic pressure and contacts:
///
///     sum f_el r_ij = 2 p_el L_x L_y, f_el r_ij ~ (1 - r_ij/d_ij)^(alpha - 1), N Z/2 contacts
///
/// NaN where nothing touched.
double mean_overlap(FinishedRun const& finished);

/// By how much the kinetic and elastic energy may have changed while it was measured, over the work
/// of the shear: p_kin and, as V_ij ~ overlap f_ij r_ij / alpha, p_el times the overlap at most.
double stored_share(FinishedRun const& finished);

/// A share of the power of the shear that is neither dissipated nor kept.
struct EnergyGap {
  double gap, error;  ///< above 0: not dissipated
  double stored;      ///< see stored_share
  std::vector<std::pair<std::string, double>> numbers() const {
    return {{"energy_gap", gap}, {"error", error}, {"stored", stored}};
  }
  std::string in_words() const;  ///< "3.2% of the power of the shear is not dissipated"
};

/// That of a run, where it is known to a good error and beyond `most`, its errors and what may have
/// been stored.
std::optional<EnergyGap> energy_gap_beyond(double most, FinishedRun const& finished);

}  // namespace bagnold
