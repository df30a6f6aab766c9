// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/run_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <vector>

#include "src/config/errors.hpp"
#include "src/config/shell_word.hpp"
#include "src/io/atomic_file.hpp"
#include "src/io/checkpoint.hpp"
#include "src/io/trajectory_parts.hpp"
#include "src/run/messages.hpp"

namespace bagnold {

namespace fs = std::filesystem;

namespace {

constexpr char const* run_files[] = {"scene.toml",
                                     "summary.json",
                                     "result.h5",
                                     "state.h5",
                                     "failed_state.h5",
                                     "plot.png",
                                     "profiles.png",
                                     "fields.png",
                                     "histograms.png",
                                     "flow_curve.png",
                                     "report.html",
                                     "checkpoint.h5",
                                     "checkpoint.previous.h5"};

std::vector<fs::path> files_of_run(fs::path const& folder) {
  auto files = io::entries(folder, "trajectory(_[0-9]+)?[.](h5md|vtkhdf|parts)");
  std::ranges::move(io::entries(folder, "[0-9]{4}_strain_rate=[-+.e0-9]+"),  // stages of a cascade
                    std::back_inserter(files));
  std::error_code ignored;
  for (auto const* name : run_files)
    if (fs::exists(folder / name, ignored)) files.push_back(folder / name);
  return files;
}

}  // namespace

bool holds_run(fs::path const& folder) { return !files_of_run(folder).empty(); }

RunFolder::RunFolder(fs::path folder)
    : path_(std::move(folder)), lock_(std::make_unique<io::RunLock>(path_)) {
  warn(lock_->remark());
}

RunFolder RunFolder::make(fs::path const& folder, bool force) {
  auto const refuse_old = [&] {
    if (holds_run(folder) && !force)
      throw InputError(fmt::format(
          "--out {}: holds a run already; `bagnold resume {}` goes on with it, another --out keeps "
          "it, --force replaces it",
          folder.string(), shell_word(folder.string())));
  };
  refuse_old();
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw FileError(fmt::format("--out {}: the folder cannot be made ({}); choose another",
                                folder.string(), error.message()));
  RunFolder made(folder);
  refuse_old();  // another process may have been quicker
  io::remove_checkpoints(folder);
  for (auto const& file : files_of_run(folder)) {
    fs::remove_all(file, error);
    if (error)
      throw FileError(fmt::format("{}: the old run's file cannot be removed ({})", file.string(),
                                  error.message()));
  }
  return made;
}

RunFolder RunFolder::open(fs::path const& folder) {
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored))
    throw InputError(fmt::format("{}: no such folder; give the --out of a run", folder.string()));
  if (!holds_run(folder))
    throw InputError(
        fmt::format("{}: holds no run (no scene.toml, no checkpoint); start one with "
                    "`bagnold run SCENE.toml --out {}`",
                    folder.string(), shell_word(folder.string())));
  return RunFolder(folder);
}

fs::path RunFolder::trajectory(std::optional<std::int64_t> seed) const {
  return path_ / (seed ? fmt::format("trajectory_{}.h5md", *seed) : "trajectory.h5md");
}

bool begun(std::filesystem::path const& folder) {
  for (auto const* name :
       {"checkpoint.h5", "checkpoint.previous.h5", "checkpoint.h5.tmp", "result.h5"})
    if (std::filesystem::exists(folder / name)) return true;
  return false;
}

}  // namespace bagnold
