// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/make_longer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "src/config/errors.hpp"
#include "src/config/scene_file.hpp"
#include "src/config/shell_word.hpp"
#include "src/io/atomic_file.hpp"
#include "src/io/trajectory_parts.hpp"
#include "src/run/pictures.hpp"
#include "src/run/trajectory_size.hpp"

namespace bagnold {

namespace {

double& last_strain(Scene& scene) {
  auto& strain = scene.shear.strain.each;
  if (scene.shear.run_per_rate()) strain.resize(scene.shear.strain_rates.size(), strain.front());
  return strain.back();
}

/// Replaces a list of equal strains by a number.
void make_plain(NumberOrList& strain) {
  if (std::ranges::count(strain.each, strain.each.front()) == std::ssize(strain.each))
    strain = strain.each.front();
}

/// Names of the measurements on frames or contacts that keep sums over all frames.
std::string sums_of_frames(Scene const& scene) {
  std::vector<std::string> names;
  if (scene.measure.contacts && scene.shear.target_error.empty())
    names.emplace_back("measure.contacts");
  if (scene.measure.fields) names.emplace_back("measure.fields");
  if (scene.measure.rotation) names.emplace_back("measure.rotation");
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

double least_lengthening(Scene const& scene) {
  double const share = scene.shear.discard.value_or(0);
  return sums_of_frames(scene).empty() || !(share > 0) ? 1 : 1 / share;
}

namespace {

std::int64_t farthest(io::Checkpoint const& from) {
  std::int64_t step = 0;
  for (auto const& system : from.systems) step = std::max(step, system.step);
  return step;
}

}  // namespace

Scene with_strain(Scene scene, double strain, std::string const& folder) {
  if (scene.shear.ramps())
    throw InputError(fmt::format(
        "--strain {} ({} holds a ramp, whose shear.strain is spent before it goes up): its length "
        "is shear.cycles; run it anew with more of them",
        strain, folder));
  if (scene.shear.by_pieces())
    throw InputError(fmt::format(
        "--strain {} ({} holds a run with shear.protocol = \"{}\", which has no shear.strain): its "
        "length is {}; go on from its end with another scene, start.kind = \"state\" and "
        "start.file = \"{}/state.h5\"",
        strain, folder, scene.shear.protocol,
        scene.shear.controlled() ? "shear.time" : "shear.cycles", folder));
  double& last = last_strain(scene);
  if (!(strain >= last))
    throw InputError(fmt::format(
        "--strain {} ({} has shear.strain = {} {}: must be more); `bagnold "
        "run {} --set shear.strain={} --out ...` makes a shorter run",
        strain, folder, last, scene.shear.run_per_rate() ? "at its last rate" : "already",
        shell_word(folder + "/scene.toml"), strain));
  last = strain;
  make_plain(scene.shear.strain);
  return scene;
}

bool is_longer(Scene const& before, Scene const& after) {
  if (!after.shear.lengthens() || !(after.shear.strain > before.shear.strain)) return false;
  Scene as_before = after;
  as_before.shear.strain = before.shear.strain;
  return write_scene(as_before) == write_scene(before);
}

Longer::Longer(Scene before_, Scene after_)
    : before(std::move(before_)),
      after(std::move(after_)),
      plan_before(make_plan(before)),
      plan_after(make_plan(after)) {
  check_feasible(after, plan_after, /*allow_unstable=*/true);
}

void Longer::refuse_mixed_frames(io::Checkpoint const& from) const {
  auto const names = sums_of_frames(after);
  auto const reached = farthest(from);
  if (names.empty() || !discards_more() || reached <= plan_before.first_step() ||
      plan_after.first_step() >= reached)
    return;
  double const share = after.shear.discard.value_or(0.5);
  throw InputError(fmt::format(
      "--strain {} ({} hold what was seen from strain {:.6g} on, of which a run of {} discards "
      "what "
      "is before {:.6g} and keeps the rest, which nobody can tell apart any more); give at least "
      "--strain {:.6g}, or run the scene anew",
      after.shear.strain.at(0), names, plan_before.strain(plan_before.first_step()),
      after.shear.strain.at(0), plan_after.strain(plan_after.first_step()),
      before.shear.strain.at(0) / share));
}

void Longer::reopen_last_window(io::SystemCheckpoint& system) const {
  auto const columns = static_cast<std::ptrdiff_t>(system.columns);
  bool const cut = plan_before.steps % plan_before.window_steps != 0;
  if (!cut || system.step < plan_before.steps || system.window_weight.empty()) return;
  system.open_sums.assign(system.window_sums.end() - columns, system.window_sums.end());
  system.open_weight = system.window_weight.back();
  system.window_sums.erase(system.window_sums.end() - columns, system.window_sums.end());
  system.window_weight.pop_back();
}

std::vector<std::string> Longer::remarks(io::Checkpoint const& from) const {
  std::vector<std::string> lines{fmt::format(
      "made longer, from strain {} to {}: ends as a run of {} from the start, scheme {}",
      before.shear.strain.at(0), after.shear.strain.at(0), after.shear.strain.at(0),
      after.integration.scheme)};
  if (!after.shear.discard)
    lines.push_back(fmt::format(
        "shear.discard = \"auto\": the transient is looked for in all {} windows, no longer in {}",
        plan_after.windows, plan_before.windows));
  else if (discards_more())
    lines.push_back(fmt::format(
        "shear.discard = {}: what is measured begins at strain {:.6g}, no longer at {:.6g}",
        *after.shear.discard, plan_after.strain(plan_after.first_step()),
        plan_before.strain(plan_before.first_step())));
  if (!after.shear.target_error.empty())
    lines.emplace_back("shear.target_error may end it sooner, as it would from the start");
  if (plan_after.trajectory_steps > 0) {
    auto const size = trajectory_size(after, plan_after);
    lines.push_back(fmt::format("trajectory: {:.0f} frames, {:.3g} MB, no longer {:.0f} frames",
                                size.frames, size.bytes / 1e6,
                                trajectory_size(before, plan_before).frames));
  }
  bool const looked_ahead = std::ranges::any_of(from.systems, [](auto const& system) {
    auto const found = system.memory.find("looking_ahead");
    return found != system.memory.end() && found->second != 0;
  });
  if (!from.whole && looked_ahead && farthest(from) >= plan_before.steps)
    lines.emplace_back(
        "an older version ended this run in the middle of a lookahead: what follows differs from "
        "one run by rounding");
  return lines;
}

void refuse_longer(RunFolder const& folder, Scene const& after) {
  auto const checkpoint = io::newest_checkpoint(folder.path(), nullptr);
  if (!checkpoint && io::run_finished(folder.path()))
    throw InputError(fmt::format(
        "{}: has no checkpoint that verifies, from which it could go on; run its scene.toml anew "
        "with --set shear.strain={}",
        folder.path().string(), after.shear.strain.at(0)));
  if (checkpoint) {
    auto const before = parse_scene(checkpoint->scene, "scene in the checkpoint", folder.path());
    if (!(write_scene(before) == write_scene(after)))
      Longer(before, after).refuse_mixed_frames(*checkpoint);
  }
}

void make_longer(RunFolder const& folder, Scene const& after) {
  refuse_longer(folder, after);
  io::remove_file(folder.summary());  // first: without it the run counts as unfinished
  io::replace_text(folder.scene(), write_scene(after));
}

void drop_results(RunFolder const& folder) {
  io::remove_file(folder.summary());
  io::remove_file(folder.state());
  drop_pictures(folder);
}

}  // namespace bagnold
