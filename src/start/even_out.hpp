// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/state/state.hpp"

namespace bagnold {

/// Takes the long waves out of the density of random disks, delta = phi(r)/phi - 1, which have to
/// travel through the box where overlaps are relaxed: moves each disk by
///
///     u = grad psi,   Laplace psi = delta,
///
/// so that div u = delta and, to first order, no delta is left. [d_s]; about 1 d_s. Shorter waves
/// than some of the squares in which delta is counted stay as they are. On one thread of the host.
/// Of a state without offset.
void even_out(State& state);

}  // namespace bagnold
