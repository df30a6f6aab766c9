// SPDX-License-Identifier: BSD-3-Clause
#include "src/cli/commands.hpp"
#include "src/config/scene_file.hpp"

namespace bagnold {

Scene read_scene(SceneOptions const& options) {
  return read_scene(options.scene_file, options.overrides);
}

}  // namespace bagnold
