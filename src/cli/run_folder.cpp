// SPDX-License-Identifier: BSD-3-Clause
#include "src/cli/run_folder.hpp"

#include <fmt/format.h>

#include <span>

#include "src/config/errors.hpp"
#include "src/io/atomic_file.hpp"
#include "src/io/checkpoint.hpp"

namespace bagnold {

namespace fs = std::filesystem;

namespace {

constexpr char const* run_files[] = {"scene.toml",     "summary.json",           "result.h5",
                                     "state.h5",       "failed_state.h5",        "plot.png",
                                     "trajectory.h5md", "trajectory.xdmf",       "profiles.png",
                                     "trajectory.parts", "fields.png",
                                     "checkpoint.h5",  "checkpoint.previous.h5"};

bool holds_run(fs::path const& folder) {
  std::error_code ignored;
  for (auto const* name : run_files)
    if (fs::exists(folder / name, ignored)) return true;
  return false;
}

}  // namespace

RunFolder::RunFolder(fs::path folder)
    : path_(std::move(folder)), lock_(std::make_unique<io::RunLock>(path_)) {}

RunFolder RunFolder::make(fs::path const& folder, bool force) {
  auto const refuse_old = [&] {
    if (holds_run(folder) && !force)
      throw InputError(fmt::format(
          "--out {}: holds a run already; `bagnold resume {}` goes on with it, another --out keeps "
          "it, --force replaces it",
          folder.string(), folder.string()));
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
  for (auto const* name : run_files) {
    fs::remove_all(folder / name, error);
    if (error)
      throw FileError(fmt::format("{}: the old run's file cannot be removed ({})",
                                  (folder / name).string(), error.message()));
  }
  return made;
}

RunFolder RunFolder::open(fs::path const& folder) {
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored))
    throw InputError(fmt::format("{}: no such folder; give the --out of a run", folder.string()));
  if (!holds_run(folder))
    throw InputError(fmt::format("{}: holds no run (no scene.toml, no checkpoint); start one with "
                                 "`bagnold run SCENE.toml --out {}`",
                                 folder.string(), folder.string()));
  return RunFolder(folder);
}

void RunFolder::remove_trajectory_parts() const {
  auto const parts = path_ / "trajectory.parts";
  std::error_code error;
  fs::remove_all(parts, error);
  if (error)
    throw FileError(fmt::format("{} cannot be removed ({})", parts.string(), error.message()));
}

void RunFolder::write_text(fs::path const& file, std::string const& text) {
  io::replace_file(file, std::as_bytes(std::span(text)));
}

}  // namespace bagnold
