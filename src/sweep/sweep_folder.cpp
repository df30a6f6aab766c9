// SPDX-License-Identifier: BSD-3-Clause
#include "src/sweep/sweep_folder.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "src/config/errors.hpp"
#include "src/config/scene_file.hpp"
#include "src/config/shell_word.hpp"
#include "src/io/atomic_file.hpp"
#include "src/run/make_longer.hpp"
#include "src/run/run_folder.hpp"

namespace bagnold::sweep {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

std::string text_in(fs::path const& file) {
  auto const bytes = io::read_file(file);
  return {reinterpret_cast<char const*>(bytes.data()), bytes.size()};
}

/// Writes a file only if its text differs, so that the time of an old file stays the time when it
/// was made.
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

/// Removes the folder of a point that has not begun; never the target of an unusual name or a link.
void withdraw(fs::path const& points, std::string const& name) {
  auto const point = points / name;
  std::error_code error;
  bool const inside =
      !name.empty() && name != "." && name != ".." && fs::path(name).filename() == name;
  if (!inside || !fs::is_directory(fs::symlink_status(point, error)) || !not_begun(point)) return;
  for (auto const* file : {"scene.toml", ".lock"}) io::remove_file(point / file);
  fs::remove(point, error);  // where it is empty
}

Json points_json(PlacedPoints const& placed) {
  Json all = {{"schema", 1}, {"points", Json::array()}};
  for (auto const& point : placed.sweep.points)
    all["points"].push_back({{"folder", point.folder}, {"scene", write_scene(point.scene)}});
  for (auto const& left : placed.left)
    all["left"].push_back({{"folder", left.folder}, {"scene", left.scene}});
  return all;
}

}  // namespace

SweepFolder::SweepFolder(fs::path const& folder, Sweep const& sweep) : path_(fs::absolute(folder)) {
  for (auto const& point : sweep.points) names_.push_back(point.folder);
}

SweepFolder SweepFolder::make(fs::path const& folder, Sweep const& sweep) {
  return make(folder, place_points(sweep, folder));
}

SweepFolder SweepFolder::make(fs::path const& folder, PlacedPoints const& placed) {
  if (fs::exists(folder / "scene.toml") || fs::exists(folder / "checkpoint.h5"))
    throw InputError(
        fmt::format("--out {}: holds a run; choose another folder for the sweep", folder.string()));
  make_folder(folder);
  SweepFolder made(folder, placed.sweep);
  made.lock_ = std::make_unique<io::RunLock>(folder);
  for (auto const& point : placed.withdrawn) withdraw(made.path_ / "points", point);
  auto const shorter = made.shorter_on_disk(placed.sweep);
  made.make_longer(placed.sweep, shorter, refuse_longer);  // all, before one is changed
  made.write_points(placed);
  made.make_longer(placed.sweep, shorter, bagnold::make_longer);
  return made;
}

SweepFolder SweepFolder::join(fs::path const& folder, PlacedPoints const& placed) {
  auto const refuse = [&](std::string const& what) {
    throw InputError(fmt::format(
        "--out {}: {}; `bagnold sweep {} --out {} --emit-slurm` prepares it", folder.string(), what,
        shell_word(placed.sweep.origin), shell_word(folder.string())));
  };
  if (!fs::exists(folder / "points.json")) refuse("holds no sweep yet");
  if (placed.added() > 0 || !placed.longer.empty())
    refuse(fmt::format("{} has points that the folder was not prepared for", placed.sweep.origin));
  return SweepFolder(folder, placed.sweep);
}

std::string SweepFolder::in_place(std::string const& scene, std::size_t k) const {
  return write_scene(parse_scene(scene, names_[k], point(k)));
}

/// Points that were made longer since their folders were written.
std::vector<std::size_t> SweepFolder::shorter_on_disk(Sweep const& sweep) const {
  std::vector<std::size_t> points;
  for (std::size_t k = 0; k < names_.size(); ++k) {
    if (!has_results(k) && !bagnold::begun(point(k))) continue;
    auto const file = point(k) / "scene.toml";
    if (!fs::exists(file)) continue;
    auto const& wanted = sweep.points[k].scene;
    if (wanted.shear.lengthens() && read_kept_scene(file).shear.strain < wanted.shear.strain)
      points.push_back(k);
  }
  return points;
}

void SweepFolder::make_longer(Sweep const& sweep, std::vector<std::size_t> const& points,
                              void (*how)(RunFolder const&, Scene const&)) const {
  for (auto const k : points) try {
      Scene scene = read_kept_scene(point(k) / "scene.toml");
      scene.shear.strain = sweep.points[k].scene.shear.strain;
      how(RunFolder::open(point(k)), scene);
    } catch (InputError const& error) {
      throw InputError(fmt::format("{}: {}", sweep.points[k].name, error.what()));
    }
}

void SweepFolder::write_points(PlacedPoints const& placed) const {
  auto const& sweep = placed.sweep;
  put_text(path_ / "sweep.toml", sweep.text);
  put_text(path_ / "points.json", points_json(placed).dump(1) + "\n");
  for (std::size_t k = 0; k < names_.size(); ++k) {
    // a point that has done steps keeps the scene of its checkpoint
    if (has_results(k) || fs::exists(point(k) / "checkpoint.h5") ||
        fs::exists(point(k) / "checkpoint.previous.h5"))
      continue;
    make_folder(point(k));
    if (!in_use(k))
      put_text(point(k) / "scene.toml", in_place(write_scene(sweep.points[k].scene), k));
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
