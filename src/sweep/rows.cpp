// SPDX-License-Identifier: BSD-3-Clause
#include "src/sweep/rows.hpp"

#include <fmt/format.h>

#include <map>
#include <string>
#include <variant>

#include "src/config/errors.hpp"

namespace bagnold::sweep {

namespace {

constexpr double most_points = 1e5;

double count_of(SweepTable const& table) {
  double count = table.zip.empty() ? 1 : static_cast<double>(table.zip.front().values.size());
  for (auto const& key : table.grid) count *= static_cast<double>(key.values.size());
  return count;
}

/// True if a row of zip gives start.kind = "random".
bool starts_at_random(SweepTable const& table, Row const& row) {
  for (std::size_t k = 0; k < table.zip.size(); ++k) {
    auto const* text = std::get_if<std::string>(&row.values[k]->value);
    if (table.zip[k].name == "start.kind" && text && *text == "random") return true;
  }
  return false;
}

}  // namespace

std::vector<Row> rows(SweepTable const& table, std::string const& origin) {
  double const count = count_of(table);
  if (count > most_points)
    throw InputError(
        fmt::format("{}: [sweep] makes {:.6g} points (limit {:.0f}); make its lists "
                    "shorter, or several sweeps",
                    origin, count, most_points));
  bool const along_zip = table.chained_along_zip();
  std::vector<Row> all;
  std::map<std::vector<std::size_t>, std::size_t> chains, begun;
  for (std::size_t point = 0; point < static_cast<std::size_t>(count); ++point) {
    Row row;
    std::vector<std::size_t> place;  // in the lists of the keys that a chain has in common
    std::size_t rest = point;
    for (auto key = table.grid.rbegin(); key != table.grid.rend(); ++key) {
      std::size_t const index = rest % key->values.size();
      rest /= key->values.size();
      row.values.insert(row.values.begin(), &key->values[index]);
      if (key->name != table.chain) place.push_back(index);
    }
    for (auto key = table.zip.rbegin(); key != table.zip.rend(); ++key)
      row.values.insert(row.values.begin(), &key->values[rest]);
    if (table.chain.empty()) {
      place = {point};
    } else if (!along_zip) {
      place.push_back(rest);
    } else {
      if (starts_at_random(table, row)) ++begun[place];
      place.push_back(begun[place]);
    }
    row.chain = chains.try_emplace(place, chains.size()).first->second;
    all.push_back(std::move(row));
  }
  return all;
}

}  // namespace bagnold::sweep
