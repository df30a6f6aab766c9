// SPDX-License-Identifier: BSD-3-Clause
#include "src/sweep/run_sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "src/config/errors.hpp"
#include "src/config/shell_word.hpp"
#include "src/run/cores.hpp"
#include "src/run/messages.hpp"
#include "src/sweep/collect.hpp"
#include "src/sweep/placed_points.hpp"
#include "src/sweep/scheduler.hpp"

namespace bagnold::sweep {

namespace {

SweepMonitor& monitor_of(SweepOptions const& options) {
  static SweepMonitor nobody;
  return options.monitor != nullptr ? *options.monitor : nobody;
}

std::size_t jobs_of(SweepOptions const& options) {
  int const jobs = options.jobs > 0 ? options.jobs : cores() / threads_of(options);
  return static_cast<std::size_t>(std::max(1, jobs));
}

/// Runs chains and prints failures.
SweepEnd run_chains(Sweep const& sweep, SweepFolder const& folder, SweepOptions const& options,
                    std::vector<std::size_t> const& chains) {
  SweepMonitor& monitor = monitor_of(options);
  warn_of_threads_beyond_cores(threads_of(options));
  use_all_cores();
  Work const work{{options.program.string(), "resume"}, point_words(options), jobs_of(options)};
  auto const failures = Scheduler(sweep, folder, work, monitor).run(chains);
  for (auto const& failure : failures)
    say(fmt::format("{} failed with exit code {}: {}; see {}", sweep.points[failure.point].name,
                    failure.exit_code, failure.reason, folder.log(failure.point).string()));
  if (!monitor.stop_requested()) return failures.empty() ? SweepEnd::done : SweepEnd::incomplete;
  say("sweep stopped; the same command goes on");
  return SweepEnd::stopped;
}

void say_changes(PlacedPoints const& placed) {
  if (auto const text = changes(placed); !text.empty()) say(text);
}

}  // namespace

int threads_of(SweepOptions const& options) { return std::max(1, options.machine.threads); }

std::vector<std::string> point_words(SweepOptions const& options) {
  std::vector<std::string> words{"--threads", fmt::format("{}", threads_of(options))};
  if (!options.machine.backend.empty())
    words.insert(words.end(), {"--backend", options.machine.backend});
  return words;
}

SweepEnd run(Sweep const& sweep, std::filesystem::path const& name, SweepOptions const& options) {
  auto const placed = place_points(sweep, name);
  auto const folder = SweepFolder::make(name, placed);
  say_changes(placed);
  std::vector<std::size_t> chains(sweep.chains.size());
  std::iota(chains.begin(), chains.end(), std::size_t{0});
  auto const end = run_chains(placed.sweep, folder, options, chains);
  if (end == SweepEnd::stopped) return end;
  return std::max(end, write_tables(placed.sweep, folder, monitor_of(options)));
}

SweepEnd run_chain(Sweep const& sweep, std::filesystem::path const& name, std::int64_t chain,
                   SweepOptions const& options) {
  auto const chains = std::ssize(sweep.chains);
  if (chain < 1 || chain > chains)
    throw InputError(fmt::format("--chain {} (must be from 1 to {}, the chains of {})", chain,
                                 chains, sweep.origin));
  auto const placed = place_points(sweep, name);
  auto const folder = SweepFolder::join(name, placed);
  return run_chains(placed.sweep, folder, options, {static_cast<std::size_t>(chain - 1)});
}

SweepEnd collect(Sweep const& sweep, std::filesystem::path const& name,
                 SweepOptions const& options) {
  auto const placed = place_points(sweep, name);
  if (!placed.longer.empty())
    throw InputError(fmt::format(
        "--collect: {} asks for more strain than {} of its points have; put the file back as it "
        "was, {} is its copy, or run `bagnold sweep {} --out {}`, which goes on with them",
        sweep.origin, placed.longer.size(), (name / "sweep.toml").string(),
        shell_word(sweep.origin), shell_word(name.string())));
  auto const folder = SweepFolder::make(name, placed);
  say_changes(placed);
  return write_tables(placed.sweep, folder, monitor_of(options));
}

}  // namespace bagnold::sweep
