// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/config/scene.hpp"

namespace bagnold {

/// Number of collisions after which the velocity of a disk is that of the flow and not of the
/// start.
inline constexpr double fewest_collisions = 10;

/// Mean relative overlap of disks in contact, from the mean force: p_el, Z and the area of the box,
/// [d_s^2].
double mean_overlap(Scene const& scene, double elastic_pressure, double contacts, double area);

/// Largest number of collisions of a disk in a strain, at a contact number Z: Z = 2 tau_dur
/// nu_coll, a disk takes part in 2 nu_coll, and tau_dur is at least that of a head-on collision of
/// two small disks. overlap: the mean one, at which disks that are not harmonic have their
/// stiffness; 0: not known, they have that at the largest overlap.
double collisions_per_disk(Scene const& scene, double contacts, double strain, double overlap = 0);

/// Collisions a disk from the integral of Z over the time, [tau_e].
double collisions_of(Scene const& scene, double contact_time);

}  // namespace bagnold
