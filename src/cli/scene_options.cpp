// SPDX-License-Identifier: BSD-3-Clause
#include "src/cli/commands.hpp"
#include "src/config/scene_file.hpp"

namespace bagnold {

Scene read_scene(SceneOptions const& options) {
  std::vector<std::string> notes;
  auto const scene = read_scene(options.scene_file, options.overrides, &notes);
  for (auto const& note : notes) say("note: " + note);
  return scene;
}

}  // namespace bagnold
