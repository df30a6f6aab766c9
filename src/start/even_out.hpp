// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/state/state.hpp"

namespace bagnold {

/// Removes the long waves from the density of random disks, delta = phi(r)/phi - 1, which would
/// otherwise have to travel through the box while overlaps are relaxed. Moves each disk by
///
///     u = grad psi,   Laplace psi = delta,
///
/// so that div u = delta and, to first order, no delta is left; u is about 1 d_s. Waves shorter
/// than a few of the squares in which delta is counted remain. Runs on one thread of the host. The
/// state must have no offset.
void even_out(State& state);

}  // namespace bagnold
