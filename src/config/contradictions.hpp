// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "src/config/mistakes.hpp"
#include "src/config/scene.hpp"

namespace bagnold {

/// Adds mistakes of several keys together, each valid by itself; `origin`: the file. Keys with a
/// mistake already are not checked.
void find_contradictions(Scene const& scene, std::string const& origin, Mistakes& mistakes);

}  // namespace bagnold
