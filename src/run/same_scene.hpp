// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "src/config/scene.hpp"

namespace bagnold {

/// Throws InputError if the run in a folder is not of this resolved scene, with the keys that
/// differ, or if its scene.toml is missing or cannot be read.
void refuse_other_scene(std::filesystem::path const& folder, Scene const& wanted);

}  // namespace bagnold
