// SPDX-License-Identifier: BSD-3-Clause
#include "src/sweep/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "src/config/errors.hpp"
#include "src/config/scene_file.hpp"
#include "src/config/toml_text.hpp"
#include "src/sweep/rows.hpp"

namespace bagnold::sweep {

namespace {

constexpr std::size_t most_letters = 120;  ///< in the name of a folder

/// "table.key" without its table, where that is enough to tell the varied keys apart.
std::string short_name(std::string const& key, std::vector<std::string> const& keys) {
  auto const last = [](std::string const& name) { return name.substr(name.rfind('.') + 1); };
  auto const alike = [&](std::string const& other) { return last(other) == last(key); };
  return std::ranges::count_if(keys, alike) > 1 ? key : last(key);
}

/// Number, then keys and values in letters that every file system and shell takes.
std::string folder_name(std::size_t number, std::vector<std::string> const& keys,
                        std::vector<Value> const& values) {
  std::string name = fmt::format("{:04}", number);
  for (std::size_t k = 0; k < keys.size(); ++k) {
    auto part = fmt::format("_{}={}", short_name(keys[k], keys), text_of(values[k]));
    for (char& c : part) {
      bool const letter =
          (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
      if (!letter && std::string_view("_=.+-").find(c) == std::string_view::npos) c = '-';
    }
    name += part;
  }
  return name.substr(0, most_letters);
}

std::string message_name(std::size_t number, std::size_t count,
                         std::vector<std::string> const& keys, Row const& row) {
  std::string values;
  for (std::size_t k = 0; k < keys.size(); ++k)
    values += fmt::format("{}{} = {}", k == 0 ? "" : ", ", keys[k], row.values[k]->toml);
  return fmt::format("point {} of {} ({})", number, count, values);
}

/// The state of another box or another number of disks is none to go on from.
void check_step(Point const& from, Point const& to) {
  if (from.scene.disks.count != to.scene.disks.count ||
      from.scene.disks.packing_fraction != to.scene.disks.packing_fraction)
    throw InputError(
        "sweep.chain: a point starts from the state of the one before, so disks.count "
        "and disks.packing_fraction cannot change along a chain; vary them outside it");
}

/// Expands the rows of one file.
class Expansion {
 public:
  Expansion(Sweep& sweep, std::filesystem::path folder, PointCheck const& check)
      : sweep_(sweep), folder_(std::move(folder)), check_(check) {}

  void add(Row const& row, std::size_t count) {
    std::size_t const index = sweep_.points.size();
    Point point;
    point.name = message_name(index + 1, count, sweep_.keys, row);
    for (auto const* given : row.values) point.values.push_back(given->value);
    point.folder = folder_name(index + 1, sweep_.keys, point.values);
    if (row.chain == sweep_.chains.size()) sweep_.chains.emplace_back();
    auto& chain = sweep_.chains[row.chain];
    if (!chain.empty()) point.previous = chain.back();
    try {
      read_point(point, row);
      refuse_double(point);
    } catch (InputError const& error) {
      throw InputError(fmt::format("{}: {}", point.name, error.what()));
    }
    chain.push_back(index);
    sweep_.points.push_back(std::move(point));
  }

 private:
  void read_point(Point& point, Row const& row) const {
    std::vector<Override> values;
    for (std::size_t k = 0; k < sweep_.keys.size(); ++k)
      values.push_back({sweep_.keys[k], row.values[k]->toml, row.values[k]->place});
    std::string before;
    if (point.previous) {
      before = "../" + sweep_.points[*point.previous].folder + "/state.h5";
      values.push_back({"start.kind", "\"state\"", "sweep.chain"});
      values.push_back({"start.file", "\"" + before + "\"", "sweep.chain"});
    }
    point.scene = parse_point(sweep_.text, sweep_.origin, folder_, values);
    point.plan = make_plan(point.scene);
    if (point.previous) {
      point.scene.start.file = before;
      check_step(sweep_.points[*point.previous], point);
    }
    check_(point.scene, point.plan);
    point.scene.integration.time_step = point.plan.time_step;
  }

  void refuse_double(Point const& point) {
    auto const [same, is_new] = seen_.try_emplace(write_scene(point.scene), sweep_.points.size());
    if (!is_new)
      throw InputError(
          fmt::format("is the same scene as {}; leave one out", sweep_.points[same->second].name));
  }

  Sweep& sweep_;
  std::filesystem::path folder_;
  PointCheck const& check_;
  std::map<std::string, std::size_t> seen_;
};

}  // namespace

Sweep read_sweep(std::filesystem::path const& file, PointCheck const& check) {
  Sweep sweep;
  sweep.origin = file.string();
  sweep.text = read_text(file);
  SweepTable const table = read_sweep_table(sweep.text, sweep.origin);
  sweep.base = without_sweep(sweep.text, sweep.origin);
  for (auto const* keys : {&table.zip, &table.grid})
    for (auto const& key : *keys) sweep.keys.push_back(key.name);
  auto const all = rows(table, sweep.origin);
  Expansion expansion(sweep, std::filesystem::absolute(file).parent_path(), check);
  for (auto const& row : all) expansion.add(row, all.size());
  return sweep;
}

}  // namespace bagnold::sweep
