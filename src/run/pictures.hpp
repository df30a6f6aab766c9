// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/config/scene.hpp"
#include "src/run/run_folder.hpp"

namespace bagnold {

/// Draws the pictures of a finished run that its scene requests and its folder lacks; warns if one
/// cannot be drawn.
void draw_missing_pictures(RunFolder const& folder, Scene const& scene);

/// True if the scene measures something that histograms.png shows.
bool makes_histograms(Scene const& scene);

/// Removes these pictures, whether the scene requests them or not.
void drop_pictures(RunFolder const& folder);

}  // namespace bagnold
