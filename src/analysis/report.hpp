// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "src/analysis/csv.hpp"
#include "src/analysis/outcome.hpp"
#include "src/analysis/series.hpp"

namespace bagnold::analysis {

/// Tables and notes of an analysis.
struct Report {
  Rows results;                    ///< a row for each curve, or datum
  Rows drawn;                      ///< what the picture shows, see drawn_columns (panel.hpp)
  std::vector<std::string> notes;  ///< for the reader: what was left out, and why
};

/// Columns of the labels, then NAME, NAME_error, NAME_bootstrap of each parameter, chi2, freedom,
/// points, misfit, widened, failure; a row for each outcome.
Rows tabulate(std::vector<Outcome> const& outcomes, std::vector<std::string> const& parameters);

/// A note on data that weigh by a pooled error (`pooled` of `data`), and on errors widened
/// (SeedErrors); none where there is nothing to say.
void note_errors(Report& report, std::size_t pooled, std::size_t data, double widened);

/// Adds notes on fits that cannot be trusted: chi2 beyond chance, errors larger than their values.
void note_fits(Report& report, std::vector<Outcome> const& outcomes,
               std::vector<std::string> const& parameters);

/// Adds notes on data left out, and on the weights of the others.
void note_left_out(Report& report, SweepTable const& table, std::vector<Series> const& series);

}  // namespace bagnold::analysis
