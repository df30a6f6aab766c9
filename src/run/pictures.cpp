// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/pictures.hpp"

#include <filesystem>

#include "src/io/atomic_file.hpp"
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
      (scene.measure.fields && !scene.shear.ramps() && missing("fields.png")) ||
      (makes_histograms(scene) && missing("histograms.png")))
    warn(draw_frames(folder.result(), folder.path()));
}

bool makes_histograms(Scene const& scene) {
  return (scene.measure.contacts && scene.shear.target_error.empty()) || scene.measure.rotation ||
         scene.measure.fields;
}

void drop_pictures(RunFolder const& folder) {
  for (auto const* name : {"plot.png", "profiles.png", "fields.png", "histograms.png"})
    io::remove_file(folder.path() / name);
}

}  // namespace bagnold
