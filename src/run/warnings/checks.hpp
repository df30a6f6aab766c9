// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "src/run/warnings/warning.hpp"

/// Checks of a result, each of one possible fault, in a file of its own. Their criteria and reasons
/// are in docs/stability.md.
namespace bagnold {

using Check = std::optional<Warning>(FinishedRun const&);

/// Number of standard errors beyond which a deviation is not by chance: Gaussian noise exceeds it
/// in less than 1 of 10^4 cases.
inline constexpr double standard_errors = 4;

/// phi > phi_J: a yield stress remains as the rate vanishes, so neither B nor eta has a limit.
Check above_jamming;

/// Disks so soft, at this rate, that B_p or eta_p differs from that of hard disks.
Check hard_core_limit;

/// Overlaps too deep for grains.
Check large_overlap;

/// Work on the disks that is neither dissipated nor stored: the time step is too coarse.
Check energy_balance;

/// A dissipative pressure of whole contacts: the time step is too coarse for them.
Check dissipative_pressure;

/// Energy that torques put into the rotation and that it does not keep: the time step is too
/// coarse.
Check rotation_balance;

/// A time step with which a collision loses a wrong amount of energy.
Check collision_loss;

/// A bias of the method beyond integration.accuracy, or not known to be within it.
Check method_bias;

/// Implicit damping of a motion that is not overdamped: inertia, not damping, determines the flow.
Check implicit_inertia;

/// Disks in a drag whose inertia has a part in the flow: no bubbles.
Check drag_inertia;

/// Quasi-static steps with energy that is neither dissipated nor stored: inertia determines the
/// flow.
Check quasi_static_inertia;

/// A time step that is stable for a single contact, but not for the damping of a dense flow.
Check contact_network;

/// B_p or B_sigma drifts while it is measured.
Check steady_state;

/// B_p or B_sigma has no error, or replicas disagree by more than theirs.
Check error_bar;

/// Too few collisions: the state cannot have forgotten its start.
Check few_collisions;

/// Motion of all disks together on top of the shear flow, which p_kin counts as fluctuations.
Check net_momentum;

/// Motion on the scale of the whole box: bands, or a box too small.
Check box_size;

/// tau_dur without the long contacts: the run ended before they did, or no contact ended.
Check contact_durations;

/// Contacts of disks that roll, by implicit damping: short ones are missed.
Check implicit_contacts;

/// Averages at another pressure than the given one, in a box that has not come to its size.
Check pressure_not_held;

/// Averages at another stress than the given one, of a box that has not come to its speed.
Check stress_not_held;

/// Flow that has stopped, or nearly so, at given stress.
Check arrest;

/// Cycles of a packing that still relaxes: its stress drifts by as much as the oscillation moves
/// it.
Check stress_drift;

/// All checks, in the order of the summary.
inline constexpr Check* all_checks[] = {above_jamming,
                                        hard_core_limit,
                                        large_overlap,
                                        energy_balance,
                                        dissipative_pressure,
                                        rotation_balance,
                                        collision_loss,
                                        method_bias,
                                        implicit_inertia,
                                        drag_inertia,
                                        quasi_static_inertia,
                                        contact_network,
                                        steady_state,
                                        error_bar,
                                        few_collisions,
                                        net_momentum,
                                        box_size,
                                        contact_durations,
                                        implicit_contacts};

/// Checks of runs by pieces, which hold without a steady state.
inline constexpr Check* checks_of_pieces[] = {contact_network, stress_drift, few_collisions,
                                              net_momentum};

/// Checks of a flow at given stress, whose strain rate is not known before.
inline constexpr Check* checks_at_stress[] = {
    large_overlap, implicit_inertia, drag_inertia,    contact_network,
    steady_state,  net_momentum,     stress_not_held, arrest};

/// Checks of a flow at given pressure, whose packing fraction is not known before.
inline constexpr Check* checks_at_pressure[] = {
    large_overlap,  energy_balance,   dissipative_pressure, rotation_balance,
    collision_loss, implicit_inertia, drag_inertia,         contact_network,
    steady_state,   error_bar,        few_collisions,       net_momentum,
    box_size,       pressure_not_held};

/// "the mean motion against the shear flow, (-0.03, 0) d_s/tau_e, 97% of the kinetic energy"
std::string mean_motion_in_words(std::array<double, 2> const& velocity, double share);

/// True if a mean is that of a stress or a pressure to be held: within 5% and standard_errors, or
/// 20% where no error is known.
bool is_held(statistics::Estimate const& found, double wanted);

/// A time step of about `digits` digits, as a command can give it: of a ramp or an oscillation the
/// next smaller one that divides their pieces, exactly.
std::string given_step(Run const& run, double time_step, int digits);

/// Command that runs the scene with half its time step.
std::string half_the_step(FinishedRun const& finished);

/// Command that runs the scene anew by another scheme, with a step that this one chooses.
std::string by_scheme(std::string_view scheme, std::string_view suffix);

/// Mean relative overlap of contacts, 1 - r_ij/d_ij, from elastic pressure and contacts:
///
///     sum f_el r_ij = 2 p_el L_x L_y, f_el r_ij ~ (1 - r_ij/d_ij)^(alpha - 1), N Z/2 contacts
///
/// NaN where nothing touched.
double mean_overlap(FinishedRun const& finished);

/// Largest possible change of the kinetic and elastic energy during the measurement, over the work
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

/// Energy gap of a run, if its error is small and it exceeds `most` by more than its errors and the
/// energy that may have been stored.
std::optional<EnergyGap> energy_gap_beyond(double most, FinishedRun const& finished);

/// True for a run by quasi-static steps, named or chosen by scheme = "auto".
bool ends_quasi_static(Run const& run);

}  // namespace bagnold
