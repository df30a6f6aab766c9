// SPDX-License-Identifier: BSD-3-Clause
#include "src/measure/make_frames.hpp"

#include "kernels/physics/species.hpp"
#include "src/measure/fields.hpp"
#include "src/measure/profiles.hpp"
#include "src/measure/rotation.hpp"
#include "src/measure/trajectory.hpp"

namespace bagnold {

Frames make_frames(Scene const& scene, Plan const& plan, State const& start,
                   std::filesystem::path const& trajectory, std::string const& version) {
  Frames frames(plan.time_step * scene.shear.strain_rate);
  auto const first = plan.discarded_windows * plan.window_steps;
  auto const measure = [&](std::unique_ptr<FrameObserver> observer) {
    frames.add_observer(std::move(observer), plan.frame_steps, first);
  };
  if (scene.measure.profiles) {
    Slices const slices(start.box_length, start.box_height());
    measure(std::make_unique<Profiles>(scene, slices));
  }
  if (scene.measure.fields) measure(std::make_unique<Fields>(scene.shear.strain_rate));
  if (scene.measure.rotation) measure(std::make_unique<Rotation>());
  if (plan.trajectory_steps > 0) {
    io::TrajectoryHeader header{version, start.diameter, {}, scene.rotates()};
    for (double const d : start.diameter) header.mass.push_back(disk_mass(scene.mass_by_area(), d));
    auto const part_bytes = static_cast<std::size_t>(trajectory_memory) /
                            static_cast<std::size_t>(scene.disks.replicas);
    frames.add_observer(std::make_unique<Trajectory>(trajectory, std::move(header), part_bytes),
                        plan.trajectory_steps);
  }
  return frames;
}

}  // namespace bagnold
