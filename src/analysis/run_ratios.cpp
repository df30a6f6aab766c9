// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/run_ratios.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <string_view>
#include <utility>

#include "src/analysis/fit/fit.hpp"
#include "src/config/errors.hpp"
#include "src/io/atomic_file.hpp"
#include "src/io/hdf5_reader.hpp"
#include "src/statistics/jackknife.hpp"
#include "src/statistics/replicas.hpp"

namespace bagnold::analysis {
namespace {

/// An observable that is a quotient of sums, and the first of two series that is there of what goes
/// as the lower one. Results of before nu_end have nu_coll: contacts that begin, for those that
/// end.
struct MeanOver {
  std::string_view name;
  std::array<std::string_view, 2> series;
};
constexpr std::array<MeanOver, 8> means_over{{
    {"tau_dur", {"nu_end", "nu_coll"}},
    {"cluster_binary_share", {"nu_end", "nu_coll"}},
    {"v_N_rms", {"Z"}},
    {"v_T_rms", {"Z"}},
    {"v_C_T_rms", {"Z"}},
    {"v_R_rms", {"Z"}},
    {"contact_rotation_correlation", {"Z"}},
    {"mu", {"p"}},
}};

/// Values in every window of every replica, [R][n], and what they are means over.
struct Column {
  std::vector<double> value, weight;  ///< weight empty: over evaluations
};

class RunSeries {
 public:
  explicit RunSeries(std::filesystem::path const& path)
      : file_(path.string(), io::read_file(path)) {
    shape_ = file_.shape("/series/evaluations");
    evaluations_ = file_.doubles("/series/evaluations", shape_);
    discarded_ = static_cast<std::size_t>(
        std::max<std::int64_t>(0, file_.integer("/series", "discarded_windows")));
  }

  /// None without such a series.
  std::optional<Column> column(std::string const& name) const {
    if (!file_.has("/series/" + name)) return std::nullopt;
    Column out{file_.doubles("/series/" + name, shape_), {}};
    auto const over = std::ranges::find(means_over, name, &MeanOver::name);
    if (over == means_over.end()) return out;
    for (auto const series : over->series)
      if (auto const path = "/series/" + std::string(series);
          out.weight.empty() && !series.empty() && file_.has(path))
        out.weight = file_.doubles(path, shape_);
    return out;
  }

  /// A table of each replica: of each column the sum of its values by weight, and of its weights.
  /// None before the first window has ended.
  std::vector<statistics::Windows> tables(std::vector<Column> const& columns) const {
    if (evaluations_.empty()) return {};
    std::size_t const windows = shape_.back(), replicas = evaluations_.size() / windows;
    std::vector<statistics::Windows> out;
    for (std::size_t r = 0; r < replicas; ++r) {
      out.push_back({2 * columns.size(), {}, {}});
      for (std::size_t w = discarded_; w < windows; ++w) add(out.back(), columns, r * windows + w);
    }
    return out;
  }

 private:
  /// Adds a window. A window without a value is left out; one without a contact does not count in a
  /// mean over contacts.
  void add(statistics::Windows& table, std::vector<Column> const& columns, std::size_t at) const {
    double const evaluations = evaluations_[at];
    if (!(evaluations > 0.0)) return;
    std::vector<double> row;
    for (auto const& column : columns) {
      double value = column.value[at], weight = column.weight.empty() ? 1.0 : column.weight[at];
      if (!column.weight.empty() && !std::isfinite(value)) value = weight = 0.0;
      row.insert(row.end(), {evaluations * weight * value, evaluations * weight});
    }
    if (std::ranges::all_of(row, [](double sum) { return std::isfinite(sum); }))
      table.push_back(row, evaluations);
  }

  io::Hdf5Reader file_;
  io::Shape shape_;
  std::vector<double> evaluations_;
  std::size_t discarded_ = 0;
};

/// Error of f over one or two systems, from 12 long blocks of each; NaN where windows are too few.
double error_of_long_blocks(std::vector<statistics::Windows> const& tables,
                            statistics::Function const& f) {
  constexpr std::size_t blocks = 12;
  double squares = 0.0, all = 0.0;
  for (auto const& table : tables) {
    if (table.size() < 2 * blocks) return unknown;
    double const weight = std::accumulate(table.weight.begin(), table.weight.end(), 0.0);
    double const error = statistics::Jackknife(table, 0, f).error(table.size() / blocks);
    squares += weight * weight * error * error;
    all += weight;
  }
  return std::sqrt(squares) / all;
}

/// Error of f. Contacts that begin in one window and end in a later one make deviations that
/// cancel, so blocks not much longer than the longest contacts give too large an error. Where the
/// error of long blocks is smaller than chance allows (once in a hundred), it is taken.
double error_of_blocks(std::vector<statistics::Windows> const& tables,
                       statistics::Function const& f) {
  if (tables.empty()) return unknown;
  constexpr double by_chance = 0.55;
  std::vector<statistics::Windows const*> replicas;
  for (auto const& table : tables) replicas.push_back(&table);
  double const error = statistics::estimate(replicas, 0, f).all.error.value_or(unknown);
  if (replicas.size() >= statistics::fewest_replicas) return error;  // that of their scatter
  double const of_long = error_of_long_blocks(tables, f);
  return of_long < by_chance * error ? of_long : error;
}

}  // namespace

double error_of_run(std::filesystem::path const& result, std::vector<std::string> const& names,
                    OfMeans const& f) try {
  if (!std::filesystem::exists(result)) return unknown;
  RunSeries const run(result);
  std::vector<Column> columns;
  for (auto const& name : names) {
    auto column = run.column(name);
    if (!column) return unknown;
    columns.push_back(std::move(*column));
  }
  return error_of_blocks(run.tables(columns), [&](std::span<double const> averages) {
    std::vector<double> means;
    for (std::size_t k = 0; k < averages.size(); k += 2)
      means.push_back(averages[k] / averages[k + 1]);
    return f(means);
  });
} catch (InputError const&) {  // a file of another program gives no error
  return unknown;
}

}  // namespace bagnold::analysis
