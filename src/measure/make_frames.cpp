// SPDX-License-Identifier: BSD-3-Clause
#include "src/measure/make_frames.hpp"

#include <sstream>

#include "kernels/physics/species.hpp"
#include "src/config/scene_file.hpp"
#include "src/measure/each_frame.hpp"
#include "src/measure/fields.hpp"
#include "src/measure/frame_contacts.hpp"
#include "src/measure/profiles.hpp"
#include "src/measure/rotation.hpp"
#include "src/measure/trajectory.hpp"

namespace bagnold {

namespace {

/// Text of the keys on which the motion of one system depends. It leaves out the length of the run
/// and what is measured, so that a run that is made longer has the same text.
std::string motion_of(Scene scene) {
  scene.disks.replicas = 1;
  std::istringstream lines(write_scene(scene));
  std::string text, table;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("[")) table = line;
    bool const moves = table == "[disks]" || table == "[drive]" || table == "[integration]" ||
                       (table == "[shear]" && (line == table || line.starts_with("strain_rate =")));
    if (moves) text += line + "\n";
  }
  return text;
}

}  // namespace

Frames make_frames(Scene const& scene, Plan const& plan, State const& start,
                   std::filesystem::path const& trajectory, std::string const& version) {
  Frames frames(plan);
  auto const first = plan.first_step();
  auto const measure = [&](char const* name, std::unique_ptr<FrameObserver> observer) {
    if (plan.ramp) observer = std::make_unique<EachFrame>(name, std::move(observer), plan);
    frames.add_observer(std::move(observer), plan.frame_steps, first);
  };
  if (scene.measure.profiles) {
    Slices const slices(start.box_length, start.box_height());
    measure("profiles", std::make_unique<Profiles>(scene, slices));
  }
  if (scene.measure.fields) measure("fields", std::make_unique<Fields>());
  if (scene.measure.rotation) measure("rotation", std::make_unique<Rotation>());
  if (plan.trajectory_steps > 0) {
    io::TrajectoryHeader header{version, start.diameter, {}, scene.rotates(), motion_of(scene)};
    for (double const d : start.diameter) header.mass.push_back(disk_mass(scene.mass_by_area(), d));
    header.contacts = scene.measure.contact_frames;
    auto const part_bytes = static_cast<std::size_t>(trajectory_memory) /
                            static_cast<std::size_t>(scene.disks.replicas);
    auto const contacts = [scene, dt = plan.time_step](Frame const& frame,
                                                       ContactRecord const* record) {
      return frame_contacts(scene, frame, record, dt);
    };
    frames.add_observer(
        std::make_unique<Trajectory>(trajectory, std::move(header), part_bytes, contacts),
        plan.trajectory_steps);
  }
  return frames;
}

}  // namespace bagnold
