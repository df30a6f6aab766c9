// SPDX-License-Identifier: BSD-3-Clause
#include "src/sweep/placed_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "src/config/errors.hpp"
#include "src/config/scene_file.hpp"
#include "src/config/schemes.hpp"
#include "src/io/atomic_file.hpp"
#include "src/io/run_lock.hpp"

namespace bagnold::sweep {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// A point that exists.
struct Known {
  std::string folder, scene;
  Scene read;            ///< start.file absolute
  bool started = false;  ///< another one starts from its last state
  bool taken = false;
};

/// Scene read by the reader, which adds the defaults of keys that an older program did not have,
/// and makes start.file absolute.
Scene read_in(fs::path const& points, std::string const& scene, std::string const& name) {
  return parse_scene(scene, name, points / name);
}

std::string but_for_strain(Scene scene) {
  scene.shear.strain = 1.0;
  return write_scene(scene);
}

std::vector<Known> read_known(fs::path const& folder) {
  auto const file = folder / "points.json";
  if (!fs::exists(file)) return {};
  auto const bytes = io::read_file(file);
  auto const* text = reinterpret_cast<char const*>(bytes.data());
  Json const all = Json::parse(text, text + bytes.size(), nullptr, /*allow_exceptions=*/false);
  if (!all.is_object() || !all.contains("points") || !all["points"].is_array())
    throw InputError(fmt::format("{}: is damaged; choose another --out", file.string()));
  std::vector<Known> known;
  for (auto const* list : {"points", "left"})
    for (auto const& point : all.value(list, Json::array())) {
      auto const name = point.value("folder", ""), scene = point.value("scene", "");
      known.push_back({name, scene, read_in(folder / "points", scene, name)});
    }
  std::set<std::string> starts;
  for (auto const& point : known) starts.insert(point.read.start.file);
  for (auto& point : known)
    point.started = starts.contains((folder / "points" / point.folder / "state.h5").string());
  return known;
}

/// Numbers new points after the existing ones.
class Numbers {
 public:
  explicit Numbers(std::vector<Known> const& known) {
    for (auto const& point : known)
      last_ = std::max(last_, std::strtoul(point.folder.c_str(), nullptr, 10));
  }

  /// "0003_elasticity=10" with the next number.
  std::string next(std::string const& name) {
    return fmt::format("{:04}{}", ++last_, name.substr(name.find_first_not_of("0123456789")));
  }

 private:
  unsigned long last_ = 0;
};

/// Existing points by their scenes, in the order of the folder's file.
class Places {
 public:
  explicit Places(std::vector<Known> known) : known_(std::move(known)) {
    for (auto& point : known_) {
      exact_.emplace(write_scene(point.read), &point);
      shorter_.emplace(but_for_strain(point.read), &point);
    }
  }

  Known* exact(Scene const& scene) const {
    auto const at = exact_.find(write_scene(scene));
    return at == exact_.end() ? nullptr : at->second;
  }

  /// Longest point with the same scene and less strain.
  Known* shorter(Scene const& scene) const {
    Known* best = nullptr;
    auto const [begin, end] = shorter_.equal_range(but_for_strain(scene));
    for (auto at = begin; at != end; ++at) {
      Known* const one = at->second;
      double const strain = one->read.shear.strain;
      if (!scene.shear.lengthens() || one->started || one->taken || !(strain < scene.shear.strain))
        continue;
      if (best == nullptr || strain > best->read.shear.strain) best = one;
    }
    return best;
  }

  std::vector<Known>& all() { return known_; }

 private:
  std::vector<Known> known_;
  std::map<std::string, Known*> exact_;
  std::multimap<std::string, Known*> shorter_;
};

/// Places the points of a sweep among the existing ones.
PlacedPoints placed_among(std::vector<Known> const& known_points, Sweep sweep,
                          fs::path const& folder) {
  Places places(known_points);
  Numbers numbers(known_points);
  bool const is_new = known_points.empty();
  PlacedPoints placed;
  std::vector<Known*> found(sweep.points.size(), nullptr);
  auto const scene_of = [&](Point& point) {
    if (point.previous)
      point.scene.start.file = "../" + sweep.points[*point.previous].folder + "/state.h5";
    return read_in(folder / "points", write_scene(point.scene), point.folder);
  };
  auto const take = [&](std::size_t k, Known* known) {
    found[k] = known;
    if (known == nullptr) return;
    known->taken = true;
    ++placed.kept;
    sweep.points[k].folder = known->folder;
  };
  // What starts from a point that is not there, or that is made longer, is another point.
  std::set<std::size_t> not_there;
  auto const starts_anew = [&](Point const& point) {
    return point.previous && not_there.contains(*point.previous);
  };
  for (std::size_t k = 0; k < sweep.points.size() && !is_new; ++k) {
    auto& point = sweep.points[k];
    if (!starts_anew(point)) take(k, places.exact(scene_of(point)));
    if (found[k] == nullptr) not_there.insert(k);
  }
  for (std::size_t k = 0; k < sweep.points.size() && !is_new; ++k) {
    if (found[k] != nullptr) continue;
    auto& point = sweep.points[k];
    auto const scene = scene_of(point);
    if (!starts_anew(point)) take(k, places.shorter(scene));
    if (found[k] != nullptr)
      placed.longer.push_back(k);
    else
      point.folder = numbers.next(point.folder);
  }
  for (auto const& point : places.all())
    if (!point.taken) placed.left.push_back({point.folder, point.scene});
  placed.sweep = std::move(sweep);
  return placed;
}

/// First line in which two texts differ, "old -> new".
std::string difference(std::string const& old_text, std::string const& new_text) {
  std::istringstream old_lines(old_text), new_lines(new_text);
  for (std::string before, after;
       std::getline(old_lines, before) && std::getline(new_lines, after);)
    if (before != after) return fmt::format("`{}` there, `{}` now", before, after);
  return "another length";
}

/// What to say where more strain chooses another scheme than that of the points.
std::string kept_scheme(Scene const& before, Scene const& after) {
  auto const& scheme = before.integration.scheme;
  if (after.integration.scheme != automatic || scheme == automatic) return "";
  return fmt::format(
      ", and scheme = \"auto\" by its strain: integration.scheme = \"{}\" keeps theirs", scheme);
}

}  // namespace

PlacedPoints place_points(Sweep const& sweep, fs::path const& name) {
  auto const folder = fs::absolute(name).lexically_normal();
  auto const known = read_known(folder);
  auto placed = placed_among(known, sweep, folder);
  if (!placed.left.empty() || !placed.longer.empty() || placed.added() > 0)
    if (std::ranges::all_of(
            known, [&](auto const& one) { return not_begun(folder / "points" / one.folder); })) {
      placed = placed_among({}, sweep, folder);
      for (auto const& one : known) placed.withdrawn.push_back(one.folder);
    }
  if (placed.withdrawn.empty() && !known.empty() && placed.kept == 0)
    throw InputError(fmt::format(
        "--out {}: holds the sweep of another file (sweep.toml is its copy): none of its {} points "
        "is in {} (its first: {}); {}choose another folder, or put the file back as it was",
        name.string(), known.size(), sweep.origin,
        difference(known.front().scene, write_scene(placed.sweep.points.front().scene)) +
            kept_scheme(known.front().read, placed.sweep.points.front().scene),
        placed.sweep.points.front().scene.shear.by_pieces()
            ? "only a steady run can be made longer; "
        : std::ranges::any_of(sweep.points,
                              [](auto const& point) { return point.previous.has_value(); })
            ? "of a chain only the last points can get more strain, for others start from the "
              "rest; "
            : ""));
  return placed;
}

bool not_begun(fs::path const& point) {
  std::error_code missing;
  for (auto const& entry : fs::directory_iterator(point, missing))
    if (auto const name = entry.path().filename(); name != "scene.toml" && name != ".lock")
      return false;
  return io::lock_holder(point).empty();
}

std::string changes(PlacedPoints const& placed) {
  if (!placed.withdrawn.empty())
    return fmt::format(
        "{} points are prepared instead of the {} that were, of which none had begun",
        placed.sweep.points.size(), placed.withdrawn.size());
  bool const same = placed.left.empty() && placed.longer.empty() && placed.added() == 0;
  if (placed.begun_with() == 0 || same) return {};
  auto text = fmt::format("{} points of {} are kept, {} are new", placed.kept, placed.sweep.origin,
                          placed.added());
  if (!placed.longer.empty())
    text += fmt::format("; {} of those that are kept get more strain", placed.longer.size());
  if (!placed.left.empty()) {
    text += fmt::format("; {} that left the file stay in points/ without a row in the tables: {}",
                        placed.left.size(), placed.left.front().folder);
    if (placed.left.size() > 1) text += " ...";
  }
  return text;
}

}  // namespace bagnold::sweep
