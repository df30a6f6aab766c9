// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace bagnold::analysis {

/// True for the name of a column that says which run or part of a run a row is of, not what it
/// measured: a scene key, which has a dot, or the number of a piece. Ratios and products are none.
bool is_key(std::string_view name);

/// True for scene keys that say what is sheared and how, not for how long or in how many replicas.
bool is_physics(std::string_view key);

/// Values of one scene key, one a point: numbers or texts, the other is empty.
struct KeyColumn {
  std::vector<double> numbers;
  std::vector<std::string> texts;

  bool is_text() const { return !texts.empty(); }
};

/// Means and standard errors of one observable, one a point; NaN where not known.
struct Measured {
  std::vector<double> mean, error;
};

/// Results of a sweep: P points.
struct SweepTable {
  std::string origin;                           ///< the file, for messages
  std::size_t points = 0;                       ///< P
  std::map<std::string, KeyColumn> keys;        ///< the varied ones, by "table.key"
  std::set<std::string> between_sweeps;         ///< of them those that vary in no single sweep
  std::map<std::string, Measured> observables;  ///< by NAME
  std::vector<std::size_t> sweep;   ///< of each point; empty unless joined sweeps lack scenes
  std::vector<std::string> scenes;  ///< the resolved scenes, TOML; may be empty
  std::vector<std::filesystem::path> runs;  ///< folders of the points; may be empty
  std::size_t hardly_met = 0;  ///< points whose run warns of few_collisions: no value is kept

  /// Errors of ratios and products of observables that were worked out from the runs, one a point,
  /// by A/B. Copies of a table share them.
  std::shared_ptr<std::map<std::string, std::vector<double>>> ratio_errors =
      std::make_shared<std::map<std::string, std::vector<double>>>();

  /// Note on the points that are left out because disks hardly met in them; "" if there are none.
  std::string left_out() const;

  /// True if a point has no value of anything: it has failed.
  bool failed(std::size_t point) const;

  /// A key's values, one a point: varied or, where not, looked up in the scenes. Throws InputError
  /// for a key that no scene has, or a text.
  std::vector<double> numbers(std::string const& key) const;
};

/// Reads `sweep.h5`, or that file in a folder: `/points/KEY` [P] (numbers or texts of fixed
/// length), `/points/scene` and `/points/folder` [P], `/observables/NAME` and
/// `/observables/NAME_error` [P], `/warnings` [P] (names). Means of a point that warns of
/// few_collisions tell its start, not its flow: they are NaN. Files come from anywhere: Hdf5Reader
/// refuses what is not plain. Or a table NAME.csv like `sweep.csv` or `pieces.csv`, whose columns
/// are keys (is_key) and observables. Throws InputError, naming the file.
SweepTable read_sweep_table(std::filesystem::path const& path);

/// Several sweeps as one, their points one after another. Keys are those that any of them varies,
/// looked up in the scenes of the others, and those of is_physics in which one sweep differs from
/// another; observables those of any, NaN where one has none. Throws InputError: a key that a sweep
/// does not tell, or the same system, as a run or as a replica of one, in two of them.
SweepTable merge_tables(std::vector<SweepTable> tables);

}  // namespace bagnold::analysis
