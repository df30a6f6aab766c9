// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/physics/laws/contact.hpp"
#include "kernels/physics/schemes/scheme.hpp"

namespace bagnold {

template <ContactLaw Law, class Repulsion, class Space, Scheme Stepped>
struct SteppedSystem;

/// A scheme's step on a device: measured_forces, begin and end, as SteppedSystem calls them.
template <Scheme>
struct DeviceStep;

}  // namespace bagnold
