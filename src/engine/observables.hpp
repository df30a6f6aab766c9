// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "src/config/scene.hpp"

namespace bagnold {

/// A measured quantity: a function of averages over configurations, never a mean of ratios.
struct Observable {
  std::string_view name;
  std::string_view unit;
  std::string_view meaning;
  /// From the averages of the columns of SumColumns to the value; NaN where it is undefined.
  std::function<double(std::span<double const>)> value;
};

/// All observables of a scene in their order of output; `strain_rate` in [1/tau_e], `box_length` in
/// [d_s]. Those of the spin only where the law rotates.
std::vector<Observable> observables(Scene const& scene, double box_length);

}  // namespace bagnold
