// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "src/statistics/windows.hpp"

namespace bagnold {

/// A measured quantity: a function of averages over configurations, never a mean of ratios.
struct Observable {
  std::string_view name;
  std::string_view unit;
  std::string_view meaning;
  /// Value as a function of the averages, NaN where it is undefined: of the columns of SumColumns,
  /// or of those that an observer of frames keeps.
  std::function<double(std::span<double const>)> value;
};

/// An observable and its data: a table of each system, of windows or of frames.
struct SampledObservable {
  Observable observable;
  std::vector<statistics::Windows const*> samples;  ///< [R]
};

}  // namespace bagnold
