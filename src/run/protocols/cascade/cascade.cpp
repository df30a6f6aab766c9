// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/protocols/cascade/cascade.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>

#include "src/config/cascade.hpp"
#include "src/config/errors.hpp"
#include "src/config/run_time.hpp"
#include "src/config/scene_file.hpp"
#include "src/config/toml_text.hpp"
#include "src/io/atomic_file.hpp"
#include "src/io/trajectory_parts.hpp"
#include "src/run/make_longer.hpp"
#include "src/run/messages.hpp"
#include "src/run/pictures.hpp"
#include "src/run/plot.hpp"
#include "src/run/provenance.hpp"
#include "src/run/start_or_resume.hpp"

namespace bagnold {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Scene of a stage that has begun with less strain than the cascade says, with the cascade's
/// strain.
std::optional<Scene> longer_stage(fs::path const& path, double strain) {
  if (!begun(path) || !fs::exists(path / "scene.toml")) return std::nullopt;
  Scene stage = read_kept_scene(path / "scene.toml");
  if (stage.shear.strain >= strain) return std::nullopt;
  stage.shear.strain = strain;
  return stage;
}

/// Throws InputError where the cascade has more strain at a rate than its run, from whose end the
/// next one has started.
void refuse_more_before_others(RunFolder const& folder, Scene const& cascade) {
  auto const path = [&](std::size_t k) { return folder.path() / stage_folder(cascade, k); };
  for (std::size_t k = 0; k + 1 < cascade.shear.strain_rates.size(); ++k)
    if (begun(path(k + 1)) && longer_stage(path(k), cascade.shear.strain.at(k)))
      throw InputError(fmt::format(
          "{}: shear.strain = {} at rate {} of {} (more than its run, from whose end the next rate "
          "started); give a list of strains, of which the last alone is more",
          folder.scene().string(), cascade.shear.strain.at(k), k + 1,
          cascade.shear.strain_rates.size()));
}

/// Runs a stage, or continues it; if it is finished, draws pictures that a kill left out.
RunEnd run_stage(fs::path const& path, Scene const& scene, Machine const& machine,
                 RunMonitor& monitor) {
  if (auto const longer = longer_stage(path, scene.shear.strain))
    make_longer(RunFolder::open(path), *longer);
  if (io::run_finished(path)) {
    draw_missing_pictures(RunFolder::open(path), scene);
    return RunEnd::done;
  }
  if (begun(path)) return go_on_in(RunFolder::open(path), machine, monitor);
  auto from_file = states_in_file(scene);
  RunFolder const folder = RunFolder::make(path, /*force=*/true);
  io::replace_text(folder.scene(), write_scene(scene));
  return run_from_start(folder, scene, machine, monitor, std::move(from_file));
}

/// What `take` reads from a summary. Throws FileError where that is damaged.
template <class Take>
auto read_summary(fs::path const& summary, Take const& take) try {
  auto const bytes = io::read_file(summary);
  auto const* text = reinterpret_cast<char const*>(bytes.data());
  return take(Json::parse(text, text + bytes.size()));
} catch (Json::exception const& error) {
  throw FileError(
      fmt::format("{}: is damaged ({}); remove it and resume", summary.string(), error.what()));
}

/// Results of a stage.
Json point_of(fs::path const& summary, std::string const& name, double strain_rate) {
  return read_summary(summary, [&](Json const& stage) {
    return Json{{"folder", name},
                {"strain_rate", strain_rate},
                {"strain", stage.at("strain")},
                {"warnings", stage.value("warnings", Json::array())},
                {"notes", stage.value("notes", Json::array())},
                {"observables", stage.at("observables")}};
  });
}

/// Strain rates of a finished cascade.
std::vector<double> rates_in(fs::path const& summary) {
  return read_summary(summary, [](Json const& cascade) {
    std::vector<double> rates;
    for (auto const& point : cascade.at("points")) rates.push_back(point.at("strain_rate"));
    return rates;
  });
}

/// Writes the results of all stages, without times.
void write_summary(RunFolder const& folder, Scene const& cascade) {
  Provenance const made = provenance();
  Json summary{{"schema", 1},
               {"bagnold", {{"version", made.version}, {"git", made.git}}},
               {"points", Json::array()}};
  for (std::size_t k = 0; k < cascade.shear.strain_rates.size(); ++k) {
    auto const name = stage_folder(cascade, k);
    summary["points"].push_back(
        point_of(folder.path() / name / "summary.json", name, cascade.shear.strain_rates[k]));
  }
  io::replace_text(folder.summary(), summary.dump(2) + "\n");
}

/// Disk-steps of each stage.
std::vector<double> work_of_stages(Scene const& cascade) {
  std::vector<double> work;
  for (auto const& stage : runs_of(cascade)) work.push_back(disk_steps(stage, make_plan(stage)));
  return work;
}

}  // namespace

std::optional<Scene> cascade_in(RunFolder const& folder) {
  if (!fs::exists(folder.scene())) return std::nullopt;
  Scene scene = read_kept_scene(folder.scene());
  return scene.shear.run_per_rate() ? std::optional(scene) : std::nullopt;
}

std::optional<StageFolder> stage_folder_in_cascade(fs::path const& folder) {
  auto const absolute = (fs::absolute(folder) / "").lexically_normal().parent_path();
  auto const file = absolute.parent_path() / "scene.toml";
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) return std::nullopt;
  Scene scene;
  try {
    scene = read_kept_scene(file);
  } catch (InputError const&) {  // anyone's: what lies beside a run is no part of it
    return std::nullopt;
  }
  if (!scene.shear.run_per_rate()) return std::nullopt;
  for (std::size_t k = 0; k < scene.shear.strain_rates.size(); ++k)
    if (stage_folder(scene, k) == absolute.filename())
      return StageFolder{folder.parent_path(), std::move(scene), k};
  return std::nullopt;
}

fs::path folder_to_resume(fs::path const& folder) {
  auto const stage = stage_folder_in_cascade(folder);
  return stage ? stage->cascade : folder;
}

bool asks_for_more(RunFolder const& folder, Scene const& cascade) {
  refuse_more_before_others(folder, cascade);
  auto const& rates = cascade.shear.strain_rates;
  auto const there = rates_in(folder.summary());
  auto const [wanted, other] = std::ranges::mismatch(rates, there);
  if (other != there.end())
    throw InputError(
        fmt::format("{}: shear.strain_rates (the run there has {:g} at rate {}); a finished "
                    "cascade goes on with rates after its last; run another one into another "
                    "--out",
                    folder.scene().string(), *other, other - there.begin() + 1));
  if (wanted != rates.end()) return true;
  auto const last = rates.size() - 1;
  return longer_stage(folder.path() / stage_folder(cascade, last), cascade.shear.strain.at(last))
      .has_value();
}

void make_cascade_longer(RunFolder const& folder, Scene const& after) {
  auto const last = after.shear.strain_rates.size() - 1;
  auto const path = folder.path() / stage_folder(after, last);
  if (auto const longer = longer_stage(path, after.shear.strain.at(last)))
    refuse_longer(RunFolder::open(path), *longer);
  io::remove_file(folder.summary());
  io::remove_file(folder.path() / "flow_curve.png");
  io::replace_text(folder.scene(), write_scene(after));
}

void draw_missing_pictures_of_cascade(RunFolder const& folder, Scene const& cascade) {
  auto const stages = runs_of(cascade);
  for (std::size_t k = 0; k < stages.size(); ++k)
    if (auto const path = folder.path() / stage_folder(cascade, k); io::run_finished(path))
      draw_missing_pictures(RunFolder::open(path), stages[k]);
  auto const flow_curve = folder.path() / "flow_curve.png";
  if (cascade.output.plot && !fs::exists(flow_curve)) warn(draw_plot(folder.path(), flow_curve));
}

RunEnd run_cascade(RunFolder const& folder, Scene const& cascade, Machine const& machine,
                   RunMonitor& monitor) {
  refuse_more_before_others(folder, cascade);
  KokkosScope const kokkos(machine, cascade);
  auto const stages = cascade.shear.strain_rates.size();
  auto const work = work_of_stages(cascade);
  double const all = std::accumulate(work.begin(), work.end(), 0.0);
  double gone = 0;
  std::string before;
  for (std::size_t k = 0; k < stages; ++k) {
    monitor.part(gone / all, work[k] / all);
    gone += work[k];
    if (monitor.stop_requested()) {
      say(fmt::format("stopped before rate {} of {}; {} goes on", k + 1, stages,
                      resuming(cascade, folder.path())));
      return RunEnd::stopped;
    }
    auto const path = fs::absolute(folder.path()).lexically_normal() / stage_folder(cascade, k);
    monitor.status(
        fmt::format("strain rate {}, {} of {}", cascade.shear.strain_rates[k], k + 1, stages));
    auto const end = run_stage(path, stage_of(cascade, k, before), machine, monitor);
    if (end != RunEnd::done) return end;
    before = (path / "state.h5").string();
  }
  write_summary(folder, cascade);
  if (cascade.output.plot) warn(draw_plot(folder.path(), folder.path() / "flow_curve.png"));
  return RunEnd::done;
}

}  // namespace bagnold
