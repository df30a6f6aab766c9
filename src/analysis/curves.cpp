// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <compare>
#include <numeric>

#include "src/analysis/csv.hpp"
#include "src/config/errors.hpp"
#include "src/config/nearest_word.hpp"

namespace bagnold::analysis {
namespace {

constexpr auto seed_key = "disks.seed";

std::vector<std::string> varied_keys(SweepTable const& table) {
  std::vector<std::string> keys;
  for (auto const& [name, column] : table.keys) keys.push_back(name);
  return keys;
}

void require_varied(SweepTable const& table, std::string const& key, char const* option) {
  if (table.keys.contains(key)) return;
  auto const known = varied_keys(table);
  throw InputError(fmt::format("{} {} (not varied in {}); varied are: {}", option, key,
                               table.origin, fmt::join(known, " ")));
}

/// True if `key` has one value for each value of `along`, in all of the table.
bool has_one_value(SweepTable const& table, std::string const& key, std::string const& along) {
  std::map<std::string, std::string> value;
  for (std::size_t point = 0; point < table.points; ++point) {
    auto const [known, is_new] =
        value.emplace(key_text(table, along, point), key_text(table, key, point));
    if (!is_new && known->second != key_text(table, key, point)) return false;
  }
  return true;
}

/// True if `key` has one value for each value of `along`, and, where it is physics, the other way
/// round: packing fractions each at elasticities of their own are curves. Models, drives and keys
/// in which sweeps as a whole differ never follow.
bool follows(SweepTable const& table, std::string const& key, std::string const& along) {
  if (table.between_sweeps.contains(key) || !has_one_value(table, key, along)) return false;
  return !is_physics(key) || (!table.keys.at(key).is_text() && has_one_value(table, along, key));
}

/// Throws InputError for the seed: all seeds are one datum.
void refuse_seed(std::string const& key, char const* option) {
  if (key == seed_key)
    throw InputError(fmt::format("{} {} (seeds are one datum, their mean); --where {}=N takes one",
                                 option, key, key));
}

bool differs(SweepTable const& table, std::string const& key) {
  for (std::size_t point = 1; point < table.points; ++point)
    if (key_text(table, key, point) != key_text(table, key, 0)) return true;
  return false;
}

std::vector<std::string> keys_between_curves(SweepTable const& table, CurveChoice const& choice) {
  std::vector<std::string> keys;
  if (!choice.by.empty()) {
    for (auto const& key : choice.by) {
      refuse_seed(key, "--by");
      require_varied(table, key, "--by");
    }
    return choice.by;
  }
  auto handled = choice.apart;
  handled.push_back(choice.along);
  auto const is_handled = [&](std::string const& key) {
    return key == seed_key || !differs(table, key) ||
           std::ranges::any_of(handled, [&](auto const& other) {
             return key == other || (table.keys.contains(other) && follows(table, key, other));
           });
  };
  for (auto const& key : varied_keys(table))
    if (!is_handled(key)) keys.push_back(key);
  return keys;
}

/// Equal as numbers where both are numbers, else as texts.
bool same_value(std::string const& wanted, std::string const& found) {
  auto const a = number_in(wanted), b = number_in(found);
  return a && b ? *a == *b : wanted == found;
}

std::vector<std::string> texts_of(SweepTable const& table, std::vector<std::string> const& keys,
                                  std::size_t point) {
  std::vector<std::string> out;
  for (auto const& key : keys) out.push_back(key_text(table, key, point));
  return out;
}

/// Points that agree in all keys but the seed, in the order of the table.
std::vector<std::vector<std::size_t>> seeds_together(SweepTable const& table,
                                                     CurveChoice const& choice) {
  auto keys = varied_keys(table);
  std::erase(keys, seed_key);
  std::map<std::vector<std::string>, std::size_t> known;
  std::vector<std::vector<std::size_t>> data;
  for (auto const point : wanted_points(table, choice.where)) {
    auto const [place, is_new] = known.emplace(texts_of(table, keys, point), data.size());
    if (is_new) data.emplace_back();
    data[place->second].push_back(point);
  }
  return data;
}

}  // namespace

std::vector<std::vector<std::size_t>> seed_groups(SweepTable const& table) {
  std::vector<std::size_t> order(table.points);
  std::iota(order.begin(), order.end(), std::size_t{0});
  auto const compare = [&](std::size_t a, std::size_t b) {
    for (auto const& [name, key] : table.keys) {
      if (name == seed_key) continue;
      auto const by = key.is_text() ? std::strong_order(key.texts[a], key.texts[b])
                                    : std::strong_order(key.numbers[a], key.numbers[b]);
      if (by != 0) return by;
    }
    return std::strong_ordering::equal;
  };
  std::ranges::stable_sort(order, [&](auto a, auto b) { return compare(a, b) < 0; });
  std::vector<std::vector<std::size_t>> groups;
  for (auto const row : order) {
    if (groups.empty() || compare(groups.back().front(), row) != 0) groups.emplace_back();
    groups.back().push_back(row);
  }
  return groups;
}

std::vector<std::size_t> wanted_points(SweepTable const& table,
                                       std::map<std::string, std::string> const& where) {
  for (auto const& [key, value] : where) require_varied(table, key, "--where");
  std::vector<std::size_t> points;
  for (std::size_t point = 0; point < table.points; ++point)
    if (std::ranges::all_of(where, [&](auto const& condition) {
          return same_value(condition.second, key_text(table, condition.first, point));
        }))
      points.push_back(point);
  return points;
}

std::string key_text(SweepTable const& table, std::string const& key, std::size_t point) {
  auto const& column = table.keys.at(key);
  return column.is_text() ? column.texts[point] : fmt::format("{}", column.numbers[point]);
}

std::string mixed_data(SweepTable const& table, std::map<std::string, std::string> const& where) {
  if (table.sweep.empty()) return {};
  auto const data = seeds_together(table, {{}, {}, {}, where});
  auto const mixed = std::ranges::count_if(data, [&](auto const& rows) {
    return std::ranges::any_of(
        rows, [&](std::size_t row) { return table.sweep[row] != table.sweep[rows.front()]; });
  });
  if (mixed == 0) return {};
  return fmt::format(
      "{} of {} data are of seeds of several tables; a CSV does not tell the model and other keys "
      "that are constant in it: where they differ, add them as columns, or give folders of sweeps",
      mixed, data.size());
}

std::size_t count_failed(SweepTable const& table) {
  std::size_t count = 0;
  for (std::size_t point = 0; point < table.points; ++point) count += table.failed(point);
  return count;
}

std::vector<std::vector<Label>> labels_of(SweepTable const& table, CurveChoice const& choice) {
  auto const keys = keys_between_curves(table, choice);
  std::vector<std::vector<Label>> all;
  for (auto const point : wanted_points(table, choice.where)) {
    std::vector<Label> labels;
    for (auto const& key : keys) labels.emplace_back(key, key_text(table, key, point));
    if (std::ranges::find(all, labels) == all.end()) all.push_back(std::move(labels));
  }
  return all;
}

std::vector<Curve> curves_of(SweepTable const& table, CurveChoice const& choice) {
  refuse_seed(choice.along, "the key along a curve is");
  require_varied(table, choice.along, "the key along a curve is");
  auto const along = table.numbers(choice.along);
  auto const keys = keys_between_curves(table, choice);
  std::vector<Curve> curves;
  std::vector<std::vector<double>> places;
  std::map<std::vector<std::string>, std::size_t> known;
  std::uint32_t number = 0;
  for (auto const& rows : seeds_together(table, choice)) {
    auto const texts = texts_of(table, keys, rows.front());
    auto const [place, is_new] = known.emplace(texts, curves.size());
    if (is_new) {
      curves.emplace_back();
      for (std::size_t k = 0; k < keys.size(); ++k)
        curves.back().labels.emplace_back(keys[k], texts[k]);
    }
    auto& data = curves[place->second].data;
    data.push_back({number++, rows});
  }
  if (curves.empty()) throw InputError("--where leaves no point; correct it");
  for (auto& curve : curves) {
    auto const where = [&](Datum const& datum) { return along[datum.rows.front()]; };
    std::ranges::stable_sort(curve.data, {}, where);
    auto const twice = std::ranges::adjacent_find(curve.data, {}, where);
    if (twice != curve.data.end())
      throw InputError(
          fmt::format("two data at {} = {} of one curve; name the key in which they "
                      "differ with --by, or pick with --where",
                      choice.along, where(*twice)));
    for (auto& datum : curve.data)
      std::erase_if(datum.rows, [&](std::size_t row) { return table.failed(row); });
  }
  return curves;
}

}  // namespace bagnold::analysis
