// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/config/scene.hpp"
#include "src/run/run_folder.hpp"

namespace bagnold {

/// Draws the pictures of a finished run that its scene asks for and its folder lacks; a warning
/// where one cannot be drawn.
void draw_missing_pictures(RunFolder const& folder, Scene const& scene);

/// Whether the scene measures what histograms.png shows.
bool makes_histograms(Scene const& scene);

/// Removes these pictures, whether the scene asks for them or not.
void drop_pictures(RunFolder const& folder);

}  // namespace bagnold
