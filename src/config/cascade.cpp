// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/cascade.hpp"

#include <fmt/format.h>

namespace bagnold {

Scene stage_of(Scene const& cascade, std::size_t stage, std::string const& before) {
  Scene scene = cascade;
  scene.shear.protocol = "steady";
  scene.shear.strain_rate = cascade.shear.strain_rates.at(stage);
  scene.shear.strain_rates.clear();
  scene.shear.strain = cascade.shear.strain.at(stage);
  if (stage > 0) {
    scene.start.kind = "state";
    scene.start.file = before;
    scene.start.copies = false;
    scene.start.rescale = true;
    scene.start.relax = false;  // the contacts of the rate before are those of the flow
  }
  return scene;
}

std::string stage_folder(Scene const& cascade, std::size_t stage) {
  return fmt::format("{:04}_strain_rate={}", stage + 1, cascade.shear.strain_rates.at(stage));
}

std::vector<std::string> stage_folders(Scene const& cascade) {
  std::vector<std::string> names;
  for (std::size_t k = 0; k < cascade.shear.strain_rates.size(); ++k)
    names.push_back(stage_folder(cascade, k));
  return names;
}

std::vector<Scene> runs_of(Scene const& scene) {
  if (!scene.shear.run_per_rate()) return {scene};
  std::vector<Scene> runs;
  for (std::size_t k = 0; k < scene.shear.strain_rates.size(); ++k)
    runs.push_back(stage_of(
        scene, k, k == 0 ? "" : fmt::format("../{}/state.h5", stage_folder(scene, k - 1))));
  return runs;
}

}  // namespace bagnold
