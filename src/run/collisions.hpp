// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/config/scene.hpp"

namespace bagnold {

/// Collisions of a disk after which its velocity is that of the flow and not of the start.
inline constexpr double fewest_collisions = 10;

/// How often a disk collides at most in a strain, with so many contacts Z at a time: Z = 2 tau_dur
/// nu_coll, a disk has part in 2 nu_coll, and tau_dur is a head-on collision's of two small disks
/// at least.
double collisions_per_disk(Scene const& scene, double contacts, double strain);

}  // namespace bagnold
