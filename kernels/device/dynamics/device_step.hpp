// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/physics/laws/contact.hpp"

namespace bagnold {

template <ContactLaw Law, class Repulsion, class Space, class Scheme>
struct SteppedSystem;

/// The step of a scheme on a device, by its form: measured_forces, begin and end, as SteppedSystem
/// calls them.
template <class Scheme>
struct DeviceStep;

}  // namespace bagnold
