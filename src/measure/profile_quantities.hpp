// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "src/measure/slices.hpp"

namespace bagnold {

/// A quantity in one slice as a function of averages: the columns of the slice below, of the slice
/// itself and of the one above, [3][SliceColumns::count]. NaN where it is undefined.
struct ProfileQuantity {
  std::string_view name;
  std::string_view unit;
  std::string_view meaning;
  std::function<double(std::span<double const>)> value;
  bool grows = false;  ///< gammadot y is to be added: the quantity is not periodic
};

/// All quantities of a run at one strain rate, [1/tau_e]; that of the spin only where disks rotate.
///
/// The mean flow of a slice, (w + gammadot y, v_y), is that of its mass, a straight line in y
/// fitted to all frames together. The kinetic stress is relative to this flow, so neither shear
/// within a slice nor the small number of disks of a frame in it biases the granular temperature.
std::vector<ProfileQuantity> profile_quantities(Slices const& slices, double strain_rate,
                                                bool rotates);

}  // namespace bagnold
