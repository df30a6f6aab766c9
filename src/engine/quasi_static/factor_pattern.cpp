// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/quasi_static/factor_pattern.hpp"

#include <algorithm>

namespace bagnold::quasi_static {

namespace {

constexpr std::int32_t none = -1;

/// The matrix by rows.
struct Rows {
  std::vector<std::int32_t> first, column;

  Rows(std::size_t count, std::vector<Entry> const& entries)
      : first(count + 1), column(entries.size()) {
    for (auto const& e : entries) ++first[static_cast<std::size_t>(e.row) + 1];
    for (std::size_t k = 0; k < count; ++k) first[k + 1] += first[k];
    auto at = first;
    for (auto const& e : entries)
      column[static_cast<std::size_t>(at[static_cast<std::size_t>(e.row)]++)] = e.column;
  }
};

/// Calls visit(k, i) for every block (i, k) of L below the diagonal, row by row: from each block of
/// the matrix up the elimination tree, which is extended on the way where `parent` has no entry.
template <class Visit>
void each_block(Rows const& rows, std::vector<std::int32_t>& parent, Visit const& visit) {
  std::vector<std::int32_t> seen(parent.size(), none);
  for (std::size_t i = 0; i < parent.size(); ++i) {
    auto const row = static_cast<std::int32_t>(i);
    seen[i] = row;
    for (auto q = rows.first[i]; q < rows.first[i + 1]; ++q)
      for (auto k = static_cast<std::size_t>(rows.column[static_cast<std::size_t>(q)]);
           seen[k] != row; k = static_cast<std::size_t>(parent[k])) {
        if (parent[k] == none) parent[k] = row;
        seen[k] = row;
        visit(k, row);
      }
  }
}

}  // namespace

FactorPattern::FactorPattern(std::int32_t columns, std::vector<Entry> const& entries)
    : first(static_cast<std::size_t>(columns) + 1) {
  auto const count = static_cast<std::size_t>(columns);
  Rows const rows(count, entries);
  std::vector<std::int32_t> parent(count, none);
  each_block(rows, parent, [&](std::size_t k, std::int32_t) { ++first[k + 1]; });
  for (std::size_t k = 0; k < count; ++k) first[k + 1] += first[k] + 1;
  row.resize(static_cast<std::size_t>(first[count]));
  auto at = first;
  for (std::int32_t k = 0; k < columns; ++k) {
    auto& next = at[static_cast<std::size_t>(k)];
    row[static_cast<std::size_t>(next++)] = k;
  }
  each_block(rows, parent,
             [&](std::size_t k, std::int32_t i) { row[static_cast<std::size_t>(at[k]++)] = i; });
  last_of_group.assign(count, 1);
  auto const rows_of = [&](std::size_t k) { return first[k + 1] - first[k]; };
  for (std::size_t k = 0; k + 1 < count; ++k)  // all below a column are below its parent too
    last_of_group[k] =
        parent[k] != static_cast<std::int32_t>(k + 1) || rows_of(k) != rows_of(k + 1) + 1;
}

std::size_t FactorPattern::find(Entry const& entry) const {
  auto const column = static_cast<std::size_t>(entry.column);
  auto const found =
      std::lower_bound(row.begin() + first[column], row.begin() + first[column + 1], entry.row);
  return static_cast<std::size_t>(found - row.begin());
}

}  // namespace bagnold::quasi_static
