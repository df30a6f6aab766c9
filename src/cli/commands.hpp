// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "src/analysis/analyse.hpp"
#include "src/cli/command_line.hpp"
#include "src/run/machine.hpp"
#include "src/run/messages.hpp"

namespace bagnold {

struct Scene;

struct SceneOptions {
  std::filesystem::path scene_file;
  std::vector<std::string> overrides;  ///< "table.key=value"
  std::filesystem::path folder;        ///< "": results/NAME of the scene file
  Machine machine;
  bool quiet = false;
  bool all = false;  ///< the whole table
  bool force = false;
  bool allow_unstable = false;
};

/// Reads the scene of the file with its overrides. Words that have a new name are reported on
/// stderr.
Scene read_scene(SceneOptions const& options);

struct ResumeOptions {
  std::filesystem::path folder;
  std::optional<double> strain;  ///< make it as long
  Machine machine;
  bool quiet = false;
  bool all = false;  ///< the whole table
};

struct PlotOptions {
  std::filesystem::path folder;
  std::string format = "png";
};

struct AnalyseOptions {
  analysis::KindRequest asked;
  std::vector<std::string> sweeps;  ///< folders or sweep.h5, joined
  std::filesystem::path prefix;     ///< of the files written; "": the first folder and the kind
  std::string format = "png";       ///< of the picture
  bool quiet = false;
};

struct SweepFileOptions {
  std::filesystem::path sweep_file;
  std::filesystem::path folder;       ///< "": results/NAME of the sweep file
  Machine machine;                    ///< of each point; threads = 0: 1
  int jobs = 0;                       ///< points at a time; 0: as many as the cores take
  std::optional<std::int64_t> chain;  ///< run this chain only, from 1
  bool collect = false;               ///< write the tables of what is there
  bool emit_slurm = false;            ///< prepare the folder and write job scripts
  std::int64_t tasks = 0;             ///< of the array of jobs at most; 0: as many as Slurm takes
  bool quiet = false;
  bool allow_unstable = false;
};

struct CheckLimitOptions {
  SceneOptions run;         ///< folder "": results/NAME-limit
  int jobs = 0;             ///< runs at a time; 0: as many as the cores take
  double tolerance = 0.05;  ///< relative change that counts as none
};

struct FigureOptions {
  std::string name;              ///< "P2-15"; "": list all
  std::filesystem::path folder;  ///< for pictures, and data that figures share; "": results/figures
  std::filesystem::path figures;  ///< figures.toml; "": found
  std::filesystem::path data;     ///< folder of finished tables to draw from; "": run sweeps
  std::string format = "png";     ///< of the picture
  int jobs = 0;                   ///< as of a sweep
  bool quick = false;
  bool quiet = false;
};

/// A command of the program: its words on the command line, and what it does once they are read.
struct Command {
  Words words;

  /// Returns the exit code: 0 done, 130 or 143 interrupted with a checkpoint written. What goes
  /// wrong is thrown: InputError, NumericalError, FileError.
  std::function<int()> run;
};

using AddCommand = Command(Words program);

AddCommand add_init, add_schema, add_units, add_run, add_validate, add_resume, add_status,
    add_watch, add_plot, add_sweep, add_analyse, add_chart, add_check_limit, add_figure, add_movie,
    add_report, add_export, add_import, add_info;

/// All commands, in the order of the help.
inline constexpr AddCommand* all_commands[] = {
    add_init,   add_run,     add_validate, add_resume,      add_status, add_watch, add_plot,
    add_sweep,  add_analyse, add_chart,    add_check_limit, add_figure, add_movie, add_report,
    add_export, add_import,  add_schema,   add_units,       add_info};

struct ValidateOptions : SceneOptions {
  bool no_time = false;  ///< no trials, which are what takes long
};

/// Prints points, chains, steps and time of a sweep file.
int validate_sweep_command(ValidateOptions const& options);

}  // namespace bagnold
