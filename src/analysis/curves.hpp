// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "src/analysis/sweep_table.hpp"

namespace bagnold::analysis {

/// Points that differ in nothing but the seed: one datum.
struct Datum {
  std::uint32_t number;           ///< in the order of the table
  std::vector<std::size_t> rows;  ///< its seeds in the table, failed ones left out; may be empty
};

/// A key and its value as text: {"disks.elasticity", "10"}.
using Label = std::pair<std::string, std::string>;

/// Data along which one key varies, in its rising order, the other keys being constant.
struct Curve {
  std::vector<Label> labels;  ///< keys that differ between the curves
  std::vector<Datum> data;
};

struct CurveChoice {
  std::string along;               ///< the key that runs
  std::vector<std::string> by;     ///< keys that tell curves apart; empty: found, see curves_of
  std::vector<std::string> apart;  ///< keys that the caller looks after; where `by` is found only
  std::map<std::string, std::string> where;  ///< only points whose key has this value
};

/// All curves of a sweep. Curves differ in the keys `by`; by default these are the varied keys
/// other than `along`, `apart`, disks.seed, and those whose value follows from that of `along` or
/// of a key in `apart` (a strain chosen for each strain rate), unless they are physical texts,
/// physical numbers shared by several of these values, or tell joined sweeps apart. Throws
/// InputError: a key that was not varied, or two data at one place of a curve.
std::vector<Curve> curves_of(SweepTable const& table, CurveChoice const& choice);

/// Labels of all curves, in the order of the table; `along` need not tell their points apart.
std::vector<std::vector<Label>> labels_of(SweepTable const& table, CurveChoice const& choice);

/// Points at which each key of `where` has its value. Throws InputError: a key that was not varied.
std::vector<std::size_t> wanted_points(SweepTable const& table,
                                       std::map<std::string, std::string> const& where);

/// All points by data: those that differ in the seed only lie together.
std::vector<std::vector<std::size_t>> seed_groups(SweepTable const& table);

/// Note on data that mix seeds of several joined tables of which one has no scenes; "" if there are
/// none. `where` as of wanted_points.
std::string mixed_data(SweepTable const& table, std::map<std::string, std::string> const& where);

/// Points that failed.
std::size_t count_failed(SweepTable const& table);

/// The value of a key at a point, as text: shortest form that reads back to the same number.
std::string key_text(SweepTable const& table, std::string const& key, std::size_t point);

}  // namespace bagnold::analysis
