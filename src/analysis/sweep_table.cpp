// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/sweep_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "src/analysis/csv.hpp"
#include "src/analysis/curves.hpp"
#include "src/config/errors.hpp"
#include "src/config/key_values.hpp"
#include "src/config/nearest_word.hpp"
#include "src/io/atomic_file.hpp"
#include "src/io/hdf5_reader.hpp"

namespace bagnold::analysis {
namespace {

constexpr std::string_view error_ending = "_error";
constexpr auto seed_key = "disks.seed", replicas_key = "disks.replicas";
constexpr std::string_view scene_name = "scene", folder_name = "folder";
constexpr std::string_view texts[] = {"rough_errors", "warnings", "notes", "folder"};

std::size_t count_points(io::Hdf5Reader const& file, std::string const& first) {
  auto const shape = file.shape(first);
  if (shape.size() != 1 || shape.front() == 0)
    throw InputError(
        fmt::format("{} of the sweep table holds no row of values; run the sweep first", first));
  return shape.front();
}

void read_keys(io::Hdf5Reader const& file, SweepTable& table) {
  for (auto const& name : file.members("/points")) {
    auto const path = "/points/" + name;
    if (table.points == 0) table.points = count_points(file, path);
    if (name == scene_name) {
      table.scenes = file.texts(path, table.points);
    } else if (name == folder_name && file.holds_text(path)) {
      auto const points = std::filesystem::path(table.origin).parent_path() / "points";
      for (auto const& folder : file.texts(path, table.points))
        table.runs.push_back(points / std::filesystem::path(folder).filename());
    } else if (name.find('.') == std::string::npos) {
      continue;  // about the point: no key of the scene
    } else if (file.holds_text(path)) {
      table.keys[name].texts = file.texts(path, table.points);
    } else {
      table.keys[name].numbers = file.doubles(path, {table.points});
      for (double const value : table.keys[name].numbers)
        if (!std::isfinite(value))
          throw InputError(fmt::format("{}: {} = {} (must be finite); make the table again",
                                       table.origin, path, value));
    }
  }
}

void read_observables(io::Hdf5Reader const& file, SweepTable& table) {
  for (auto const& name : file.members("/observables")) {
    if (name.ends_with(error_ending)) continue;
    auto const path = "/observables/" + name;
    auto const error_path = path + std::string(error_ending);
    if (table.points == 0) table.points = count_points(file, path);
    auto& measured = table.observables[name];
    measured.mean = file.doubles(path, {table.points});
    measured.error = file.has(error_path) ? file.doubles(error_path, {table.points})
                                          : std::vector<double>(table.points, std::nan(""));
  }
}

/// Drops values of points with few collisions: they describe no flow. B_p = 1e-32 +- 0 is not to be
/// averaged in.
void drop_few_collisions(SweepTable& table, std::vector<std::string> const& warnings) {
  for (std::size_t point = 0; point < warnings.size(); ++point) {
    if (warnings[point].find("few_collisions") == std::string::npos) continue;
    ++table.hardly_met;
    for (auto& [name, measured] : table.observables)
      measured.mean[point] = measured.error[point] = std::nan("");
  }
}

KeyColumn key_column(Rows const& rows, std::size_t column) {
  KeyColumn out;
  for (auto const& row : rows.rows) {
    out.texts.push_back(row[column]);
    if (auto const number = number_in(row[column])) out.numbers.push_back(*number);
  }
  (out.numbers.size() == rows.rows.size() ? out.texts.clear() : out.numbers.clear());
  return out;
}

std::vector<double> cells(SweepTable const& table, Rows const& rows, std::string const& name) {
  auto const found = std::ranges::find(rows.columns, name);
  std::vector<double> out(rows.rows.size(), std::nan(""));
  if (found == rows.columns.end()) return out;
  auto const column = static_cast<std::size_t>(found - rows.columns.begin());
  for (std::size_t k = 0; k < out.size(); ++k) {
    auto const& text = rows.rows[k][column];
    if (text.empty()) continue;
    auto const number = number_in(text);
    if (!number)
      throw InputError(fmt::format("{}: {} = \"{}\" (must be a finite number, or empty)",
                                   table.origin, name, text));
    out[k] = *number;
  }
  return out;
}

SweepTable read_csv_table(std::filesystem::path const& path) {
  SweepTable table;
  table.origin = path.string();
  auto const bytes = io::read_file(path);
  auto const rows =
      parse_csv({reinterpret_cast<char const*>(bytes.data()), bytes.size()}, table.origin);
  table.points = rows.rows.size();
  if (table.points == 0)
    throw InputError(fmt::format("{}: holds no row of values; make it again", table.origin));
  for (std::size_t column = 0; column < rows.columns.size(); ++column) {
    auto const& name = rows.columns[column];
    if (std::ranges::count(rows.columns, name) > 1)
      throw InputError(
          fmt::format("{}: {} (two columns have this name); rename one", table.origin, name));
    if (is_key(name))
      table.keys[name] = key_column(rows, column);
    else if (!name.ends_with(error_ending) && std::ranges::count(texts, name) == 0)
      table.observables[name] = {cells(table, rows, name),
                                 cells(table, rows, name + std::string(error_ending))};
  }
  if (auto const found = std::ranges::find(rows.columns, "warnings"); found != rows.columns.end())
    drop_few_collisions(
        table, key_column(rows, static_cast<std::size_t>(found - rows.columns.begin())).texts);
  return table;
}

/// Values of the keys of one of the scenes of a table; name: of the scene, in messages.
std::vector<KeyValue> values_of(SweepTable const& table, std::size_t point,
                                std::string const& name) {
  return key_values(table.scenes[point], name, std::filesystem::path(table.origin).parent_path());
}

/// Values of a scene's physical keys, as numbers or texts; no key without a value.
std::map<std::string, KeyColumn> physics_of(SweepTable const& table) {
  std::map<std::string, KeyColumn> found;
  for (auto const& [name, number, text] : values_of(table, 0, table.origin)) {
    if (!is_physics(name)) continue;
    if (number) found[name].numbers = {*number};
    if (text) found[name].texts = {*text};
  }
  return found;
}

/// Adds keys that differ between sweeps and vary in none of them: each becomes a varied key.
void tell_apart(std::vector<SweepTable>& tables) {
  if (std::ranges::any_of(tables, [](auto const& one) { return one.scenes.empty(); })) return;
  std::vector<std::map<std::string, KeyColumn>> all;
  for (auto const& table : tables) all.push_back(physics_of(table));
  auto const has_number = [](auto const& one) {
    auto const found = one.find("shear.inertial_number");
    return found != one.end() && !found->second.numbers.empty();
  };
  bool const rate_follows = std::ranges::all_of(all, has_number);  // from the pressure
  for (auto const& [key, first] : all.front()) {
    if (rate_follows && key == "shear.strain_rate") continue;
    if (std::ranges::any_of(all, [&](auto const& other) { return !other.contains(key); })) continue;
    auto const differs = [&](auto const& other) {
      auto const& value = other.at(key);
      return value.numbers != first.numbers || value.texts != first.texts;
    };
    if (std::ranges::none_of(all, differs)) continue;
    bool const varied =
        std::ranges::any_of(tables, [&](auto const& table) { return table.keys.contains(key); });
    for (std::size_t k = 0; k < tables.size(); ++k) {
      if (tables[k].keys.contains(key)) continue;
      auto const& value = all[k].at(key);
      auto& column = tables[k].keys[key];
      if (!value.numbers.empty()) column.numbers.assign(tables[k].points, value.numbers.front());
      if (!value.texts.empty()) column.texts.assign(tables[k].points, value.texts.front());
      if (!varied) tables[k].between_sweeps.insert(key);
    }
  }
}

/// Replicas of each point, [P]: as the keys or, where they do not vary, the first scene says; 1
/// where nothing does.
std::vector<double> replicas_of(SweepTable const& table) {
  if (auto const varied = table.keys.find(replicas_key); varied != table.keys.end())
    return varied->second.numbers;
  std::vector<double> replicas(table.points, 1.0);
  if (table.scenes.empty()) return replicas;
  auto const values = values_of(table, 0, table.origin);
  auto const found = std::ranges::find(values, replicas_key, &KeyValue::name);
  if (found != values.end() && found->number) std::ranges::fill(replicas, *found->number);
  return replicas;
}

/// Throws InputError for points of two sweeps that share a system: of the same state and seed, or
/// of seeds so near that their replicas have some in common. replicas, sweep: of each point, [P].
void refuse_twice(SweepTable const& table, std::vector<double> const& replicas,
                  std::vector<std::size_t> const& sweep) {
  struct Systems {
    double seed, replicas;  ///< seeds from `seed` to before `seed` + `replicas`
    std::size_t sweep;
  };
  std::map<std::vector<std::string>, std::vector<Systems>> seen;
  for (std::size_t point = 0; point < table.points; ++point) {
    std::vector<std::string> place;
    double seed = 0.0;
    for (auto const& [name, column] : table.keys) {
      if (name == seed_key && !column.is_text())
        seed = column.numbers[point];
      else if (name != replicas_key)
        place.push_back(fmt::format("{} = {}", name, key_text(table, name, point)));
    }
    auto& systems = seen[place];
    for (auto const& other : systems) {
      bool const shared = other.sweep != sweep[point] && seed < other.seed + other.replicas &&
                          other.seed < seed + replicas[point];
      if (!shared) continue;
      if (table.keys.contains(seed_key)) place.push_back(fmt::format("{} = {}", seed_key, seed));
      auto const both = fmt::format("{}: {}", table.origin, fmt::join(place, ", "));
      throw InputError(
          seed == other.seed && replicas[point] == other.replicas
              ? both + " is in both; leave it out of one, or give it another seed"
              : fmt::format("{} has {} replicas, some of which are among the {} of the seed {}; "
                            "leave one of them out",
                            both, replicas[point], other.replicas, other.seed));
    }
    systems.push_back({seed, replicas[point], sweep[point]});
  }
}

/// A key of all points of a table: its column or, where it does not vary, its value in the scenes.
KeyColumn column_of(SweepTable const& table, std::string const& key) {
  if (auto const own = table.keys.find(key); own != table.keys.end()) return own->second;
  KeyColumn out;
  for (std::size_t point = 0; point < table.scenes.size(); ++point) {
    auto const values = values_of(table, point, table.origin);
    auto const found = std::ranges::find(values, key, &KeyValue::name);
    if (found == values.end() || !found->text) break;
    out.texts.push_back(*found->text);
  }
  if (out.texts.size() == table.points) return out;
  return {table.numbers(key), {}};
}

}  // namespace

bool is_key(std::string_view name) {
  return (name.find('.') != std::string_view::npos || name == "piece") &&
         name.find_first_of("*/") == std::string_view::npos;
}

bool is_physics(std::string_view key) {
  constexpr std::string_view of_shear[] = {
      "protocol",  "strain_rate",     "ramp_rate", "strain_rate_high", "pieces",
      "amplitude", "period",          "peak_rate", "stress",           "box_inertia",
      "pressure",  "inertial_number", "response"};
  if (key.starts_with("shear."))
    return std::ranges::count(of_shear, key.substr(std::string_view("shear.").size())) > 0;
  return (key.starts_with("disks.") && key != replicas_key) || key.starts_with("drive.");
}

std::string SweepTable::left_out() const {
  if (hardly_met == 0) return {};
  return fmt::format(
      "{} of {} points are left out: disks hardly met in them (few_collisions); longer runs would "
      "tell",
      hardly_met, points);
}

bool SweepTable::failed(std::size_t point) const {
  return std::ranges::none_of(
      observables, [&](auto const& one) { return std::isfinite(one.second.mean[point]); });
}

std::vector<double> SweepTable::numbers(std::string const& key) const {
  if (auto const found = keys.find(key); found != keys.end()) {
    if (found->second.is_text()) {
      auto const& texts = found->second.texts;
      auto const odd = std::ranges::find_if(texts, [](auto const& one) { return !number_in(one); });
      auto const& text = odd == texts.end() ? texts.front() : *odd;  // numbers written as texts
      throw InputError(fmt::format(
          "{} = \"{}\" (is no number); {}", key, text,
          text.empty() ? "fill in the empty cells of " + origin : "choose another key"));
    }
    return found->second.numbers;
  }
  std::vector<double> out;
  for (std::size_t point = 0; point < scenes.size(); ++point) {
    auto const values =
        values_of(*this, point, fmt::format("{}, scene of point {}", origin, point));
    auto const found = std::ranges::find(values, key, &KeyValue::name);
    if (found == values.end() || !found->number) break;
    out.push_back(*found->number);
  }
  if (out.size() == points) return out;
  std::vector<std::string> known;
  for (auto const& [name, column] : keys) known.push_back(name);
  throw InputError(
      fmt::format("{} (no number of that name in {}){}", key, origin, did_you_mean(key, known)));
}

SweepTable read_sweep_table(std::filesystem::path const& path) {
  if (path.extension() == ".csv" && std::filesystem::exists(path)) return read_csv_table(path);
  auto const file_path = std::filesystem::is_directory(path) ? path / "sweep.h5" : path;
  if (!std::filesystem::exists(file_path))
    throw InputError(fmt::format("{} is not there; run `bagnold sweep` first, or give its folder",
                                 file_path.string()));
  SweepTable table;
  table.origin = file_path.string();
  io::Hdf5Reader const file(table.origin, io::read_file(file_path));
  read_keys(file, table);
  read_observables(file, table);
  if (table.observables.empty() && file.has("/pieces"))
    throw InputError(
        fmt::format("{}: its points are sequences or lists of stresses, whose averages are of "
                    "pieces; give {}, a row a piece",
                    table.origin, (file_path.parent_path() / "pieces.csv").string()));
  if (table.observables.empty())
    throw InputError(fmt::format("{}: /observables is empty; run the sweep first", table.origin));
  if (file.has("/warnings") && file.holds_text("/warnings"))
    drop_few_collisions(table, file.texts("/warnings", table.points));
  return table;
}

SweepTable merge_tables(std::vector<SweepTable> tables) {
  if (tables.size() == 1) return std::move(tables.front());
  tell_apart(tables);
  SweepTable out;
  for (auto const& table : tables) {
    out.origin += (out.origin.empty() ? "" : " and ") + table.origin;
    for (auto const& [name, column] : table.keys) out.keys[name];
    out.between_sweeps.insert(table.between_sweeps.begin(), table.between_sweeps.end());
    for (auto const& [name, values] : table.observables) out.observables[name];
  }
  auto const append = [](auto& to, auto const& from) {
    to.insert(to.end(), from.begin(), from.end());
  };
  std::vector<double> replicas;
  std::vector<std::size_t> sweep;
  for (auto const& table : tables) {
    append(replicas, replicas_of(table));
    sweep.resize(replicas.size(), static_cast<std::size_t>(&table - tables.data()));
    for (auto& [name, column] : out.keys) {
      auto const own = column_of(table, name);
      append(column.texts, own.texts);
      append(column.numbers, own.numbers);
    }
    for (auto& [name, values] : out.observables) {
      auto const own = table.observables.find(name);
      std::vector<double> const none(table.points, std::nan(""));
      append(values.mean, own == table.observables.end() ? none : own->second.mean);
      append(values.error, own == table.observables.end() ? none : own->second.error);
    }
    append(out.scenes, table.scenes);
    append(out.runs, table.runs);
    out.points += table.points;
    out.hardly_met += table.hardly_met;
  }
  if (out.scenes.size() != out.points) {
    out.scenes.clear();
    out.sweep = sweep;
  }
  if (out.runs.size() != out.points) out.runs.clear();
  for (auto const& [name, column] : out.keys)
    if (column.is_text() && !column.numbers.empty())
      throw InputError(
          fmt::format("{} is a text in one and a number in another of {}", name, out.origin));
  refuse_twice(out, replicas, sweep);
  return out;
}

}  // namespace bagnold::analysis
