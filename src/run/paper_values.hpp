// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "src/config/scene.hpp"
#include "src/measure/observables.hpp"

namespace bagnold {

/// A number that one of the two papers states in its text for scenes like this one.
struct PaperValue {
  std::string quantity;                                  ///< "p_kin/p"
  std::string stated;                                    ///< "about 0.10"
  std::string source;                                    ///< "P1 Sec. III A"
  std::function<double(std::span<double const>)> value;  ///< ours, of the averages
};

/// Values of the papers for a scene; numbers read off figures are not among them.
std::vector<PaperValue> paper_values(Scene const& scene, std::vector<Observable> const& list);

}  // namespace bagnold
