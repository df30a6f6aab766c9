// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/pictures.hpp"

#include <filesystem>

#include "src/run/messages.hpp"
#include "src/run/plot.hpp"

namespace bagnold {

void draw_missing_pictures(RunFolder const& folder, Scene const& scene) {
  if (!scene.output.plot) return;
  auto const missing = [&](char const* name) {
    return !std::filesystem::exists(folder.path() / name);
  };
  if (missing("plot.png")) warn(draw_plot(folder.result(), folder.picture()));
  if ((scene.measure.profiles && missing("profiles.png")) ||
      (scene.measure.fields && missing("fields.png")))
    warn(draw_frames(folder.result(), folder.path()));
}

}  // namespace bagnold
