// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "src/analysis/random.hpp"
#include "src/analysis/seed_errors.hpp"
#include "src/analysis/sweep_table.hpp"

namespace bagnold::analysis {

/// A mean over seeds and its standard error; NaN where not known.
struct Value {
  double mean, error;
  bool pooled = false;  ///< a run without an error of its own weighs as SeedErrors has it
};

/// Mean over n seeds, those that are NaN left out, and its error from the seeds' own errors e_i,
/// (sum e_i^2)^(1/2) / n. The error from their scatter, [sum (x_i - mean)^2 / (n (n - 1))]^(1/2)
/// times Student's factor, is taken instead where a seed has no error, and where the seeds differ
/// by more than chance allows at 1% (chi2 with n - 1 degrees of freedom): near a transition block
/// errors are too small. The larger of both would give too little weight to points that scatter by
/// chance, and a fit's bootstrap would then be too small by a quarter with two seeds.
Value merge_seeds(std::span<double const> means, std::span<double const> errors);

/// A number that each datum of a sweep has: what goes on an axis. By name:
/// - `table.key`, a scene key (no error);
/// - NAME, an observable, merged over seeds, errors of runs widened and put in as the whole sweep
///   tells (SeedErrors);
/// - `phi_J-phi`, the distance to jamming, phi_J given (no error);
/// - A/B, A*B, the ratio or product of two of these after merging; of several signs the last one is
///   worked out last. Observables of one run vary together, so its error is that of its own blocks
///   in each run (error_of_run), then merged over seeds as that of an observable. Where the runs'
///   series are not there, as for tables in CSV without a column A/B and A/B_error, it is from
///   three seeds on the jackknife's over seeds, times Student's factor; of one or two seeds errors
///   are added as independent then, and too large for most ratios.
class Quantity {
 public:
  /// Keeps a reference to the table. Throws InputError for an unknown name, with the nearest one.
  Quantity(SweepTable const& table, std::string const& name, std::optional<double> phi_j = {});

  /// Value of one datum. all: rows of the table that are its seeds; those without a value of one of
  /// the parts of a ratio or product are left out. Where the bias of the method was measured its
  /// error is (error^2 + bias^2 + bias_error^2)^(1/2). All seeds have the same bias, so the mean
  /// over seeds has all of it; that of a ratio or product is to first order.
  Value of(std::span<std::size_t const> all) const;

  /// The same with the statistical error alone.
  Value without_bias(std::span<std::size_t const> all) const;

  /// Value of one datum resampled: n - 1 of its n seeds, of those that have a value, drawn with
  /// replacement. All quantities share the draw. With n - 1 the variance of the mean is right; with
  /// n it would be too small by (n - 1) / n (Rao and Wu, J. Am. Stat. Assoc. 83, 231 (1988)). A
  /// single seed is shifted by a normal number times its statistical error instead; each observable
  /// has its own number.
  double resampled(std::span<std::size_t const> all, Draw const& draw) const;

  /// True if the quantity is made of keys alone, so exact.
  bool is_key() const {
    return !observable_ && (!first_ || (first_->is_key() && second_->is_key()));
  }

  /// Factor by which errors of runs are widened; the largest of its parts.
  double widened() const;

 private:
  Value measured(Measured const& observable, SeedErrors const& pool,
                 std::span<std::size_t const> rows) const;

  /// Value of one datum as in of(), without the error of a ratio from its own blocks.
  Value of_merged(std::span<std::size_t const> rows) const;

  /// Names of the observables it is made of, from left to right; its value in a row from theirs;
  /// and its error in each row, from its own blocks (error_of_run) or as the table has it.
  std::vector<std::string> observables() const;
  double of_observables(std::size_t row, std::span<double const> means) const;
  std::vector<double> errors_of_runs() const;

  /// A ratio or product of at least two observables as one, with the errors of its own blocks;
  /// nullptr if no run has them. Computed on first use.
  struct OwnErrors {
    Measured measured;
    SeedErrors pool;
  };
  OwnErrors const* own_errors() const;

  /// Keys and observables of which it is made, from left to right; and its value from theirs, which
  /// it removes from the front of `means`.
  void add_parts(std::vector<Quantity const*>& parts) const;
  double of_parts(std::span<double const>& means) const;

  /// The jackknife over seeds (statistics/jackknife.hpp) of a ratio or product, times Student's
  /// factor; NaN for fewer than statistics::fewest_replicas.
  double error_of_seeds(std::span<std::size_t const> rows) const;

  /// Mean of one datum, the bias of the method in it and the error of that.
  struct Bias {
    double mean, bias, error;
  };
  Bias bias(std::span<std::size_t const> rows) const;
  bool has_bias() const;

  /// Rows in which all observables that it is made of have a value.
  std::vector<std::size_t> present(std::span<std::size_t const> rows) const;

  std::string name_;
  std::vector<double> number_;            ///< of a key or phi_J-phi, one a row
  Measured const* observable_ = nullptr;  ///< of an observable
  Measured const* bias_ = nullptr;        ///< of the method in it, where it was measured
  SeedErrors errors_{};                   ///< of an observable
  std::shared_ptr<Quantity const> first_, second_;
  bool divides_ = false;  ///< first_ / second_; else their product
  SweepTable const* table_;
  mutable std::optional<OwnErrors> own_errors_ = {};
  mutable bool own_errors_sought_ = false;
};

}  // namespace bagnold::analysis
