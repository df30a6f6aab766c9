// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tuple>

#include "kernels/physics/drives/stokes_drag.hpp"
#include "kernels/physics/drives/thermal_bath.hpp"

namespace bagnold {

/// Every one-body force there is, beside none at all: the program and its messages read this list.
using Drives = std::tuple<StokesDrag,  //
                          ThermalBath>;

}  // namespace bagnold
