// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "src/config/mistakes.hpp"
#include "src/config/scene.hpp"

namespace bagnold {

/// Adds what the keys of a scene, each right by itself, get wrong together; `origin`: its file.
/// Keys of which there is a mistake already are not looked at.
void find_contradictions(Scene const& scene, std::string const& origin, Mistakes& mistakes);

}  // namespace bagnold
