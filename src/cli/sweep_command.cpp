// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <numeric>
#include <sstream>
#include <thread>

#include "src/cli/checked_sweep.hpp"
#include "src/cli/options.hpp"
#include "src/cli/signals.hpp"
#include "src/config/errors.hpp"
#include "src/io/atomic_file.hpp"
#include "src/run/provenance.hpp"
#include "src/run/run_folder.hpp"
#include "src/run/run_time_estimate.hpp"
#include "src/sweep/results.hpp"
#include "src/sweep/scheduler.hpp"
#include "src/sweep/slurm.hpp"

namespace bagnold {

namespace {

namespace fs = std::filesystem;

int threads_of(SweepOptions const& options) { return std::max(1, options.machine.threads); }

std::size_t jobs_of(SweepOptions const& options) {
  auto const cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  int const jobs = options.jobs > 0 ? options.jobs : cores / threads_of(options);
  return static_cast<std::size_t>(std::max(1, jobs));
}

std::vector<std::string> point_options(SweepOptions const& options) {
  std::vector<std::string> words{"--threads", fmt::format("{}", threads_of(options))};
  if (!options.machine.backend.empty())
    words.insert(words.end(), {"--backend", options.machine.backend});
  return words;
}

fs::path this_program() { return fs::read_symlink("/proc/self/exe"); }

/// Runs chains, says what failed; returns the exit code.
int run_chains(sweep::Sweep const& sweep, sweep::SweepFolder const& folder,
               SweepOptions const& options, std::vector<std::size_t> const& chains) {
  sweep::ProgressLine line(sweep, options.quiet);
  sweep::Work const work{
      {this_program().string(), "resume"}, point_options(options), jobs_of(options), [] {
        return stop_signal() != 0;
      }};
  auto const failures = sweep::Scheduler(sweep, folder, work, line).run(chains);
  for (auto const& failure : failures)
    say(fmt::format("{} failed with exit code {}: {}; see {}", sweep.points[failure.point].name,
                    failure.exit_code, failure.reason, folder.log(failure.point).string()));
  if (stop_signal() == 0) return failures.empty() ? 0 : 1;
  say("sweep stopped; the same command goes on");
  return 128 + stop_signal();
}

/// One line for all points that have something to warn of.
std::string warnings_of(sweep::Sweep const& sweep, sweep::Results const& results) {
  std::map<std::string, int> points;  // by name of the warning
  for (auto const& names : results.warnings) {
    std::istringstream words(names);
    for (std::string name; words >> name;) ++points[name];
  }
  auto const suspect =
      std::ranges::count_if(results.warnings, [](auto const& names) { return !names.empty(); });
  if (suspect == 0) return {};
  std::string list;
  for (auto const& [name, count] : points)
    list += fmt::format("{}{} ({})", list.empty() ? "" : ", ", name, count);
  return fmt::format("{} of {} points are suspect: {}; see warnings in their summary.json", suspect,
                     sweep.points.size(), list);
}

/// Writes sweep.csv and sweep.h5; returns 1 where a point has no result.
int write_tables(sweep::Sweep const& sweep, sweep::SweepFolder const& folder, bool quiet) {
  auto const results = sweep::read_results(sweep, folder);
  Provenance const made = provenance();
  sweep::write_csv(folder.path() / "sweep.csv", sweep, results);
  sweep::write_hdf5(folder.path() / "sweep.h5", sweep, results,
                    {{"bagnold_version", made.version}, {"git", made.git}});
  if (!quiet) warn(warnings_of(sweep, results));
  auto const done = std::ranges::count(results.status, "done");
  auto const points = std::ssize(sweep.points);
  if (!quiet)
    fmt::print("table of {} points in {}\n", points, (folder.path() / "sweep.csv").string());
  if (done == points) return 0;
  say(
      fmt::format("{} of {} points have no result: their rows are empty; the same sweep "
                  "without --collect tries them again",
                  points - done, points));
  return 1;
}

int emit_slurm(sweep::Sweep const& sweep, sweep::SweepFolder const& folder,
               SweepOptions const& options) {
  std::string words;
  for (auto const& word : point_options(options))
    words += fmt::format(" {}", sweep::shell_word(word));
  if (options.allow_unstable) words += " --allow-unstable";
  std::vector<double> seconds;
  for (auto const& time : times_of_points(sweep).each) seconds.push_back(time.most);
  sweep::SlurmJob const job{this_program(),      fs::absolute(options.sweep_file),
                            folder.path(),       words,
                            threads_of(options), std::move(seconds)};
  fs::create_directories(folder.path() / "slurm");
  auto const points = folder.path() / "points.slurm", collect = folder.path() / "collect.slurm";
  io::replace_text(points, sweep::slurm_array(sweep, job));
  io::replace_text(collect, sweep::slurm_collect(job));
  fmt::print(
      "{} points in {} chains; submit them with\n\n"
      "  job=$(sbatch --parsable {})\n"
      "  sbatch --dependency=afterany:$job {}\n",
      sweep.points.size(), sweep.chains.size(), sweep::shell_word(points.string()),
      sweep::shell_word(collect.string()));
  return 0;
}

}  // namespace

int run_sweep(sweep::Sweep const& sweep, SweepOptions const& options) {
  auto const name =
      options.folder.empty() ? fs::path("results") / options.sweep_file.stem() : options.folder;
  catch_signals();
  if (options.chain != 0) {
    auto const chains = std::ssize(sweep.chains);
    if (options.chain < 1 || options.chain > chains)
      throw InputError(fmt::format("--chain {} (must be from 1 to {}, the chains of {})",
                                   options.chain, chains, sweep.origin));
    auto const folder = sweep::SweepFolder::join(name, sweep);
    return run_chains(sweep, folder, options, {static_cast<std::size_t>(options.chain - 1)});
  }
  if (options.emit_slurm) sweep::refuse_slurm_name(name);
  auto const folder = sweep::SweepFolder::make(name, sweep);
  if (options.emit_slurm) return emit_slurm(sweep, folder, options);
  if (options.collect) return write_tables(sweep, folder, options.quiet);
  std::vector<std::size_t> chains(sweep.chains.size());
  std::iota(chains.begin(), chains.end(), std::size_t{0});
  int const status = run_chains(sweep, folder, options, chains);
  return status > 128 ? status : std::max(status, write_tables(sweep, folder, options.quiet));
}

Command add_sweep(Words program) {
  auto const options = std::make_shared<SweepOptions>();
  Words command = add_command(program, "sweep",
                              "run all points of a sweep file; the same command goes on with it");
  command.option("FILE", options->sweep_file, "scene with a table [sweep] (see inputs/)")
      .required();
  command.option("--out", options->folder, "folder for the points and tables [results/FILE]");
  command.option("--jobs", options->jobs, "points at a time [default: cores / threads]")
      .between(1, 4096);
  auto slurm = command.flag("--emit-slurm", options->emit_slurm,
                            "prepare the folder for Slurm and write job scripts; run nothing");
  auto chain = command.option("--chain", options->chain,
                              "run this chain of points only, from 1, and write no table");
  auto collect =
      command.flag("--collect", options->collect, "write the tables of what is done; run nothing");
  slurm.excludes(chain).excludes(collect);
  chain.excludes(collect);
  add_unstable_flag(command, options->allow_unstable);
  add_machine_options(command, options->machine, options->quiet);
  return {command, [options] {
            return run_sweep(read_checked_sweep(options->sweep_file, options->allow_unstable),
                             *options);
          }};
}

}  // namespace bagnold
