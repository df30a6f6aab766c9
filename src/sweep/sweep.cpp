// SPDX-License-Identifier: BSD-3-Clause
#include "src/sweep/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "src/config/cascade.hpp"
#include "src/config/errors.hpp"
#include "src/config/scene_file.hpp"
#include "src/config/time_step.hpp"
#include "src/config/toml_text.hpp"
#include "src/start/copies.hpp"
#include "src/sweep/rows.hpp"

namespace bagnold::sweep {

namespace {

constexpr std::size_t most_letters = 120;  ///< in the name of a folder

/// "table.key" without its table, if that is enough to distinguish the varied keys.
std::string short_name(std::string const& key, std::vector<std::string> const& keys) {
  auto const last = [](std::string const& name) { return name.substr(name.rfind('.') + 1); };
  auto const alike = [&](std::string const& other) { return last(other) == last(key); };
  return std::ranges::count_if(keys, alike) > 1 ? key : last(key);
}

/// Text of a value for the name of a folder: of a list its numbers, "0.001+0.5+0+100".
std::string name_of(Value const& value) {
  auto text = text_of(value);
  if (!text.starts_with('[')) return text;
  std::erase_if(text, [](char c) { return c == '[' || c == ']' || c == ' ' || c == '\n'; });
  std::ranges::replace(text, ',', '+');
  return text;
}

/// Folder name: number, then keys and values in letters that every file system and shell accepts.
std::string folder_name(std::size_t number, std::vector<std::string> const& keys,
                        std::vector<Value> const& values) {
  std::string name = fmt::format("{:04}", number);
  for (std::size_t k = 0; k < keys.size(); ++k) {
    auto part = fmt::format("_{}={}", short_name(keys[k], keys), name_of(values[k]));
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

/// Throws InputError if a point cannot start from the state of another: of another box, number of
/// disks or number of replicas, except for copies of it.
void check_step(Point const& from, Point const& to) {
  auto const &before = from.scene.disks, &after = to.scene.disks;
  auto const refuse = [](std::string const& keys, std::string const& instead) {
    throw InputError(
        fmt::format("sweep.chain: a point starts from the state of the one before, so {} cannot "
                    "change along a chain; vary them outside it{}",
                    keys, instead));
  };
  if (before.packing_fraction != after.packing_fraction || before.replicas != after.replicas)
    refuse("disks.packing_fraction and disks.replicas", "");
  if (to.scene.start.copies)
    copies_that_fit("sweep.chain: the point before", before.count, before.box_aspect, to.scene);
  else if (before.count != after.count || before.box_aspect != after.box_aspect)
    refuse("disks.count and disks.box_aspect",
           after.count > before.count && after.count % before.count == 0
               ? ", or say start.copies = [false, true] in [sweep.zip]"
               : "");
}

/// Expands the rows of one file: a row is a run or, for a cascade, a run for each of its rates.
class Expansion {
 public:
  Expansion(Sweep& sweep, std::filesystem::path folder, SweepTable const& table,
            PointCheck const& check)
      : sweep_(sweep), folder_(std::move(folder)), table_(table), check_(check) {}

  void add(Row const& row, std::size_t number, std::size_t count) {
    Point point;
    point.name = message_name(number, count, sweep_.keys, row);
    for (auto const* given : row.values) point.values.push_back(given->value);
    if (row.chain == sweep_.chains.size()) sweep_.chains.emplace_back();
    auto& chain = sweep_.chains[row.chain];
    if (!chain.empty()) point.previous = chain.back();
    auto const name = point.name;
    try {
      read_point(point, row);
      refuse_mixture(point.scene);
      if (cascade_)
        add_stages(point, row.chain);
      else
        add_run(std::move(point), row.chain);
    } catch (InputError const& error) {
      throw InputError(fmt::format("{}: {}", name, error.what()));
    }
  }

  /// Varied keys; for cascades also the rate of the stage.
  std::vector<std::string> keys() const {
    auto all = sweep_.keys;
    if (cascade_) all.emplace_back(rate_key);
    return all;
  }

 private:
  static constexpr auto rate_key = "shear.strain_rate";

  void refuse_mixture(Scene const& scene) {
    bool const is_cascade = scene.shear.run_per_rate();
    if (cascade_known_ && is_cascade != cascade_)
      throw InputError(
          "shear.protocol: some points are cascades, of a row for each rate, some are not (must be "
          "alike); make two sweeps of them");
    if (is_cascade && !table_.chain.empty())
      throw InputError(
          "sweep.chain does not go with shear.protocol = \"cascade\", which is a chain of its "
          "rates; "
          "leave it out");
    cascade_ = is_cascade;
    cascade_known_ = true;
  }

  /// Plans, checks and adds one run.
  void add_run(Point point, std::size_t chain) {
    std::size_t const index = sweep_.points.size();
    point.folder = folder_name(index + 1, keys(), point.values);
    point.plan = make_plan(point.scene);
    if (point.previous) {
      auto const& before = sweep_.points[*point.previous];
      point.scene.start.file = "../" + before.folder + "/state.h5";
      check_step(before, point);
    }
    check_(point.scene, point.plan);
    point.scene = resolved(std::move(point.scene));
    refuse_double(point);
    if (!point.previous) refuse_shared_systems(point);
    sweep_.chains[chain].push_back(index);
    sweep_.points.push_back(std::move(point));
  }

  /// Adds the runs of a cascade, as a chain.
  void add_stages(Point const& cascade, std::size_t chain) {
    for (std::size_t k = 0; k < cascade.scene.shear.strain_rates.size(); ++k) {
      Point point = cascade;
      point.values.emplace_back(cascade.scene.shear.strain_rates[k]);
      if (k > 0) point.previous = sweep_.points.size() - 1;
      point.scene = stage_of(cascade.scene, k, "");
      point.name += fmt::format(", rate {}", point.scene.shear.strain_rate);
      add_run(std::move(point), chain);
    }
  }

  void read_point(Point& point, Row const& row) const {
    std::vector<Override> values;
    for (std::size_t k = 0; k < sweep_.keys.size(); ++k)
      values.push_back({sweep_.keys[k], row.values[k]->toml, row.values[k]->place});
    if (point.previous) {
      refuse_own_file(row);
      auto const before = "../" + sweep_.points[*point.previous].folder + "/state.h5";
      values.push_back({"start.kind", "\"state\"", "sweep.chain"});
      values.push_back({"start.file", "\"" + before + "\"", "sweep.chain"});
      if (std::ranges::count(sweep_.keys, "start.relax") == 0)  // contacts are those of the flow
        values.push_back({"start.relax", "false", "sweep.chain"});
    }
    point.scene = parse_point(sweep_.text, sweep_.origin, folder_, values);
  }

  /// Refuses a file of its own for a point along a chain, where each point starts from the state of
  /// the one before.
  void refuse_own_file(Row const& row) const {
    if (!table_.chained_along_zip()) return;
    for (std::size_t k = 0; k < table_.zip.size(); ++k)
      if (table_.zip[k].name == "start.file")
        throw InputError(
            fmt::format("start.file = {} (a point of a chain starts from the state of the one "
                        "before); leave it or sweep.chain out, or put it in grid",
                        row.values[k]->toml));
  }

  void refuse_double(Point const& point) {
    auto const [same, is_new] = seen_.try_emplace(write_scene(point.scene), sweep_.points.size());
    if (!is_new)
      throw InputError(
          fmt::format("is the same scene as {}; leave one out", sweep_.points[same->second].name));
  }

  /// R replicas have the seeds seed .. seed + R - 1: points whose seeds are nearer share systems,
  /// and a mean over seeds would count these twice.
  void refuse_shared_systems(Point const& point) {
    auto alike = point.scene;
    auto const seed = std::exchange(alike.disks.seed, 0);
    auto const replicas = alike.disks.replicas;
    auto& others = seeds_[write_scene(alike)];
    for (auto const& [other, name] : others)
      if (std::max(seed, other) - std::min(seed, other) < replicas)
        throw InputError(
            fmt::format("disks.seed = {} (shares systems with {}: disks.replicas = {} has the "
                        "seeds from disks.seed to disks.seed + {}); take seeds at least {} apart",
                        seed, name, replicas, replicas - 1, replicas));
    others.emplace_back(seed, point.name);
  }

  Sweep& sweep_;
  std::filesystem::path folder_;
  SweepTable const& table_;
  bool cascade_ = false, cascade_known_ = false;  ///< what the points are, after the first
  PointCheck const& check_;
  std::map<std::string, std::size_t> seen_;
  std::map<std::string, std::vector<std::pair<std::int64_t, std::string>>> seeds_;  ///< by the rest
};

}  // namespace

Sweep read_sweep(std::filesystem::path const& file, PointCheck const& check) {
  return parse_sweep(read_text(file), file.string(), std::filesystem::absolute(file).parent_path(),
                     check);
}

Sweep parse_sweep(std::string const& text, std::string const& origin,
                  std::filesystem::path const& folder, PointCheck const& check) {
  Sweep sweep;
  sweep.origin = origin;
  sweep.text = text;
  SweepTable const table = read_sweep_table(sweep.text, sweep.origin);
  sweep.base = without_sweep(sweep.text, sweep.origin);
  for (auto const* keys : {&table.zip, &table.grid})
    for (auto const& key : *keys) sweep.keys.push_back(key.name);
  auto const all = rows(table, sweep.origin);
  Expansion expansion(sweep, folder, table, check);
  for (std::size_t k = 0; k < all.size(); ++k) expansion.add(all[k], k + 1, all.size());
  sweep.keys = expansion.keys();
  return sweep;
}

}  // namespace bagnold::sweep
