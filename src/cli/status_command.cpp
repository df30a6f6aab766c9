// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <chrono>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "src/cli/exit_code.hpp"
#include "src/cli/options.hpp"
#include "src/config/cascade.hpp"
#include "src/config/run_time.hpp"
#include "src/config/scene_file.hpp"
#include "src/config/shell_word.hpp"
#include "src/sweep/status.hpp"

namespace bagnold {

namespace {

using RunState = RunStatus::State;
constexpr std::size_t most_lines = 20;  ///< of points of a kind

std::string names_of(std::vector<std::string> const& names) {
  return fmt::format("{}", fmt::join(names, ", "));
}

/// "12 min left, until 18:40"; with the day where that is not today.
std::string until(double seconds) {
  using Clock = std::chrono::system_clock;
  auto const now = Clock::to_time_t(Clock::now());
  auto const end = now + static_cast<std::time_t>(seconds);
  auto const today = fmt::localtime(now), then = fmt::localtime(end);
  bool const same_day = today.tm_yday == then.tm_yday && today.tm_year == then.tm_year;
  return fmt::format(
      "about {} left, until {}", time_text(seconds),
      same_day ? fmt::format("{:%H:%M}", then) : fmt::format("{:%Y-%m-%d %H:%M}", then));
}

/// "running: strain 12 of 40 (30%), about 12 min left, until 18:40; host x, pid 7".
std::string line_of(RunStatus const& run) {
  if (run.state == RunState::done) {
    auto text = fmt::format("done: {} {:.4g}", run.name, run.strain);
    if (!run.warnings.empty()) text += "; warnings: " + names_of(run.warnings);
    if (!run.notes.empty()) text += "; notes: " + names_of(run.notes);
    return text;
  }
  auto text = fmt::format("{}: {} {:.4g} of {:.4g} ({:.0f}%)", word(run.state), run.name,
                          run.strain, run.whole, 100 * run.share());
  if (run.age > 0) text += fmt::format(" at its checkpoint, {} ago", time_text(run.age));
  if (run.age == 0 && run.state == RunState::running)
    text += ", its first checkpoint comes after 10 s of stepping";
  if (auto const left = run.seconds_left(); left && run.state == RunState::running)
    text += ", " + until(*left);
  else if (left && run.state != RunState::failed && *left > 0)
    text += fmt::format(", about {} of work left", time_text(*left));
  if (!run.holder.empty()) text += "; " + run.holder;
  if (!run.why.empty()) text += "; " + run.why;
  return text;
}

/// Command to continue a run; "" if it runs or is done.
std::string advice(RunState state, std::string const& folder) {
  if (state == RunState::running || state == RunState::done) return {};
  return fmt::format("`bagnold resume {}` goes on\n", shell_word(folder));
}

int print_cascade(std::string const& folder, RunStatus const& whole,
                  std::vector<RunStatus> const& stages) {
  std::size_t finished = 0;
  double left = 0;
  for (auto const& stage : stages) {
    finished += stage.state == RunState::done;
    left += stage.seconds_left().value_or(0);
  }
  bool const running = !whole.holder.empty();
  fmt::print("{}: cascade, {} of {} rates done{}\n", folder, finished, stages.size(),
             running ? "; " + whole.holder : "");
  for (std::size_t k = 0; k < stages.size(); ++k)
    fmt::print("  {:>3}  {}\n", k + 1, line_of(stages[k]));
  if (running && left > 0)
    fmt::print("this rate: {}\n", until(left));
  else if (finished < stages.size())
    fmt::print("{}", advice(RunState::stopped, folder));
  return done;
}

void print_points(sweep::SweepStatus const& status, RunState state) {
  std::size_t printed = 0;
  for (auto const& [folder, run] : status.points) {
    if (run.state != state) continue;
    if (++printed > most_lines) break;
    fmt::print("  {}  {}\n", folder, line_of(run));
  }
  if (printed > most_lines) fmt::print("  ... {} in all\n", status.count(state));
}

void print_names(sweep::SweepStatus const& status, char const* what,
                 std::vector<std::string> RunStatus::*list) {
  std::map<std::string, int> points;
  for (auto const& [folder, run] : status.points)
    for (auto const& name : run.*list) ++points[name];
  std::string text;
  for (auto const& [name, count] : points)
    text += fmt::format("{}{} ({})", text.empty() ? "" : ", ", name, count);
  if (!text.empty()) fmt::print("{}: {}\n", what, text);
}

/// Returns the exit code of the sweep itself: 1 where points have failed.
int print_sweep(std::string const& folder, sweep::SweepStatus const& status) {
  auto const count = [&](RunState state) { return status.count(state); };
  fmt::print(
      "{}: sweep of {} points: {} done, {} running, {} stopped, {} failed, {} not begun; "
      "{:.0f}% of the disk-steps\n",
      folder, status.points.size(), count(RunState::done), count(RunState::running),
      count(RunState::stopped), count(RunState::failed), count(RunState::not_begun),
      100 * status.share());
  for (auto const state : {RunState::failed, RunState::running, RunState::stopped})
    print_points(status, state);
  print_names(status, "warnings", &RunStatus::warnings);
  print_names(status, "notes", &RunStatus::notes);
  if (status.left > 0) fmt::print("{} points on the disk are no longer in the file\n", status.left);
  auto const running = count(RunState::running);
  if (auto const left = status.core_seconds_left(); left && *left > 0) {
    if (running > 0)
      fmt::print("{} at a time: {}\n", running, until(*left / static_cast<double>(running)));
    else
      fmt::print("about {} left, on one core\n", time_text(*left));
  }
  if (status.for_slurm)
    fmt::print("prepared for Slurm: `squeue --me --name=bagnold` tells what waits\n");
  if (running == 0 && status.holder.empty() && count(RunState::done) < status.points.size())
    fmt::print("`bagnold sweep FILE --out {}` goes on (a copy of FILE: {}/sweep.toml)\n",
               shell_word(folder), folder);
  return count(RunState::failed) > 0 ? points_failed : done;
}

using Json = nlohmann::ordered_json;

/// Status as JSON; unknown numbers are null.
Json json_of(RunStatus const& run) {
  auto const left = run.seconds_left();
  bool const is_strain = run.name == "strain";  // else a time, as long as it is not done
  auto const only = [](bool there, double value) { return there ? Json(value) : Json(); };
  return {{"state", word(run.state)},
          {"strain", only(is_strain, run.strain)},
          {"strain_whole", only(is_strain, run.whole)},
          {"time", only(!is_strain, run.strain)},
          {"time_whole", only(!is_strain, run.whole)},
          {"share", run.share()},
          {"seconds_left", left ? Json(*left) : Json()},
          {"seconds_since_checkpoint", run.age > 0 ? Json(run.age) : Json()},
          {"holder", run.holder},
          {"failure", run.why},
          {"warnings", run.warnings},
          {"notes", run.notes}};
}

/// Adds the rates of a cascade, and its share; strain and steps are those of each rate.
void add_stages(Json& all, std::filesystem::path const& folder,
                std::vector<RunStatus> const& stages) {
  auto const names = stage_folders(read_kept_scene(folder / "scene.toml"));
  RunStatus whole;
  for (std::size_t k = 0; k < stages.size(); ++k) {
    all["points"].push_back(json_of(stages[k]));
    all["points"].back()["folder"] = names.at(k);
    whole.work += stages[k].work;
    whole.whole_work += stages[k].whole_work;
  }
  all["share"] = whole.share();
  all["strain"] = all["strain_whole"] = Json();
}

/// Prints a run, or with `points` a cascade's rates or a sweep's points. Returns the code that the
/// text output returns.
int print_json(std::filesystem::path const& folder) {
  Json all;
  bool failed = false;
  if (auto const sweep = sweep::status_of_sweep(folder)) {
    auto const left = sweep->core_seconds_left();
    all = {{"kind", "sweep"},
           {"share", sweep->share()},
           {"core_seconds_left", left ? Json(*left) : Json()},
           {"holder", sweep->holder},
           {"points", Json::array()}};
    for (auto const& [name, run] : sweep->points) {
      all["points"].push_back(json_of(run));
      all["points"].back()["folder"] = "points/" + name;
    }
    failed = sweep->count(RunState::failed) > 0;
  } else {
    all = json_of(status_of(folder));
    auto const stages = status_of_stages(folder);
    all["kind"] = stages.empty() ? "run" : "cascade";
    if (!stages.empty()) add_stages(all, folder, stages);
  }
  fmt::print("{}\n", all.dump(1, ' ', false, Json::error_handler_t::replace));
  return failed ? points_failed : done;
}

int status_command(std::filesystem::path const& folder, bool json) {
  if (json) return print_json(folder);
  auto const name = folder.string();
  if (auto const sweep = sweep::status_of_sweep(folder)) return print_sweep(name, *sweep);
  auto const run = status_of(folder);
  if (auto const stages = status_of_stages(folder); !stages.empty())
    return print_cascade(name, run, stages);
  fmt::print("{}: {}\n{}", name, line_of(run), advice(run.state, name));
  return done;
}

}  // namespace

Command add_status(Words program) {
  struct Options {
    std::filesystem::path folder;
    bool json = false;
  };
  auto const options = std::make_shared<Options>();
  Words command = add_command(program, "status",
                              "where a run, a cascade or a sweep stands, whoever runs it: done, "
                              "running, failed, warnings, when it will end");
  command.option("DIR", options->folder, "folder of a run or a sweep").required();
  command.flag("--json", options->json, "for programs, as JSON");
  return {command, [options] { return status_command(options->folder, options->json); }};
}

}  // namespace bagnold
