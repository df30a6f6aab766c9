// SPDX-License-Identifier: BSD-3-Clause
#include "src/sweep/sweep_folder.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "src/config/errors.hpp"
#include "src/config/scene_file.hpp"
#include "src/io/atomic_file.hpp"

namespace bagnold::sweep {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

std::string text_in(fs::path const& file) {
  auto const bytes = io::read_file(file);
  return {reinterpret_cast<char const*>(bytes.data()), bytes.size()};
}

/// Only where it differs: the time of an old file tells when it was made.
void put_text(fs::path const& file, std::string const& text) {
  if (fs::exists(file) && text_in(file) == text) return;
  io::replace_text(file, text);
}

void make_folder(fs::path const& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw FileError(fmt::format("{}: the folder cannot be made ({}); choose another --out",
                                folder.string(), error.message()));
}

Json points_json(Sweep const& sweep) {
  Json all = {{"schema", 1}, {"points", Json::array()}};
  for (auto const& point : sweep.points)
    all["points"].push_back({{"folder", point.folder}, {"scene", write_scene(point.scene)}});
  return all;
}

/// The first line in which two texts differ, "old -> new".
std::string difference(std::string const& old_text, std::string const& new_text) {
  std::istringstream old_lines(old_text), new_lines(new_text);
  for (std::string before, after;
       std::getline(old_lines, before) && std::getline(new_lines, after);)
    if (before != after) return fmt::format("`{}` there, `{}` now", before, after);
  return "another length";
}

}  // namespace

SweepFolder::SweepFolder(fs::path const& folder, Sweep const& sweep) : path_(fs::absolute(folder)) {
  for (auto const& point : sweep.points) names_.push_back(point.folder);
}

SweepFolder SweepFolder::make(fs::path const& folder, Sweep const& sweep) {
  if (fs::exists(folder / "scene.toml") || fs::exists(folder / "checkpoint.h5"))
    throw InputError(
        fmt::format("--out {}: holds a run; choose another folder for the sweep", folder.string()));
  make_folder(folder);
  SweepFolder made(folder, sweep);
  made.lock_ = std::make_unique<io::RunLock>(folder);
  if (fs::exists(folder / "points.json")) made.refuse_other(sweep);
  made.write_points(sweep);
  return made;
}

SweepFolder SweepFolder::join(fs::path const& folder, Sweep const& sweep) {
  if (!fs::exists(folder / "points.json"))
    throw InputError(
        fmt::format("--out {}: holds no sweep yet; `bagnold sweep {} --out {} "
                    "--emit-slurm` prepares one",
                    folder.string(), sweep.origin, folder.string()));
  SweepFolder joined(folder, sweep);
  joined.refuse_other(sweep);
  return joined;
}

std::string SweepFolder::placed(std::string const& scene, std::size_t k) const {
  return write_scene(parse_scene(scene, names_[k], point(k)));
}

void SweepFolder::refuse_other(Sweep const& sweep) const {
  auto const file = path_ / "points.json";
  auto const refuse = [&](std::string const& what) {
    throw InputError(fmt::format(
        "--out {}: holds the sweep of another file (sweep.toml is its copy): {}; put {} back as it "
        "was, or choose another folder",
        path_.string(), what, sweep.origin));
  };
  Json const old = Json::parse(text_in(file), nullptr, /*allow_exceptions=*/false);
  if (!old.is_object() || !old.contains("points") || !old["points"].is_array())
    throw InputError(fmt::format("{}: is damaged; choose another --out", file.string()));
  auto const& points = old["points"];
  if (points.size() != sweep.points.size())
    refuse(fmt::format("{} points there, {} now", points.size(), sweep.points.size()));
  for (std::size_t k = 0; k < names_.size(); ++k) {
    auto const& point = sweep.points[k];
    auto const folder = points[k].value("folder", ""), scene = points[k].value("scene", "");
    if (folder != names_[k]) refuse(fmt::format("point {} there, {} now", folder, names_[k]));
    // through the reader, which fills in the default of a key that the older program did not know
    auto const before = placed(scene, k), now = placed(write_scene(point.scene), k);
    if (before != now) refuse(fmt::format("{}: {}", point.name, difference(before, now)));
  }
}

void SweepFolder::write_points(Sweep const& sweep) const {
  put_text(path_ / "sweep.toml", sweep.text);
  put_text(path_ / "points.json", points_json(sweep).dump(1) + "\n");
  for (std::size_t k = 0; k < names_.size(); ++k) {
    // what has steps behind it keeps the scene of its checkpoint
    if (has_results(k) || fs::exists(point(k) / "checkpoint.h5") ||
        fs::exists(point(k) / "checkpoint.previous.h5"))
      continue;
    make_folder(point(k));
    if (!in_use(k))
      put_text(point(k) / "scene.toml", placed(write_scene(sweep.points[k].scene), k));
  }
}

bool SweepFolder::in_use(std::size_t k) const {
  try {
    io::RunLock const lock(point(k));
    return false;
  } catch (InputError const&) {
    return true;
  }
}

}  // namespace bagnold::sweep
