// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <memory>

#include "src/cli/exit_code.hpp"
#include "src/cli/options.hpp"
#include "src/cli/signals.hpp"
#include "src/cli/sweep_terminal.hpp"
#include "src/config/shell_word.hpp"
#include "src/sweep/checked_sweep.hpp"
#include "src/sweep/emit_slurm.hpp"
#include "src/sweep/slurm.hpp"

namespace bagnold {

namespace {

int print_submission(sweep::Sweep const& sweep, sweep::SlurmScripts const& scripts) {
  fmt::print(
      "{} points in {} chains, {} tasks; submit them with\n\n"
      "  job=$(sbatch --parsable {})\n"
      "  sbatch --dependency=afterany:$job {}\n",
      sweep.points.size(), sweep.chains.size(), scripts.tasks, shell_word(scripts.points.string()),
      shell_word(scripts.collect.string()));
  return done;
}

int sweep_command(SweepFileOptions const& options) {
  auto const sweep = sweep::read_checked_sweep(options.sweep_file, options.allow_unstable);
  auto const folder = options.folder.empty()
                          ? std::filesystem::path("results") / options.sweep_file.stem()
                          : options.folder;
  if (auto const note = sweep::rising_chain_note(sweep);
      !note.empty() && !options.chain && !options.collect)
    say("note: " + note);
  catch_signals();
  SweepTerminal terminal(options.quiet);
  auto runs = sweep_options(options.machine, options.jobs, terminal);
  runs.tasks = options.tasks;
  if (options.chain) return exit_code_of(run_chain(sweep, folder, *options.chain, runs));
  if (options.emit_slurm)
    return print_submission(sweep, emit_slurm(sweep, folder, options.allow_unstable, runs));
  return exit_code_of(options.collect ? collect(sweep, folder, runs) : run(sweep, folder, runs));
}

}  // namespace

Command add_sweep(Words program) {
  auto const options = std::make_shared<SweepFileOptions>();
  Words command = add_command(
      program, "sweep",
      "run all points of a sweep file; the same command goes on with it, also when the file has "
      "gained points or strain");
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
  command
      .option(
          "--tasks", options->tasks,
          "with --emit-slurm: tasks of the array at most, each with several chains in turn where "
          "there are more [default: what Slurm's MaxArraySize allows]")
      .between(1, 10000000)
      .needs(slurm);
  slurm.excludes(chain).excludes(collect);
  chain.excludes(collect);
  add_unstable_flag(command, options->allow_unstable);
  add_machine_options(command, options->machine, options->quiet);
  return {command, [options] { return sweep_command(*options); }};
}

}  // namespace bagnold
