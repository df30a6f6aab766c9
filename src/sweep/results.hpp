// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "src/io/hdf5_writer.hpp"
#include "src/sweep/sweep.hpp"
#include "src/sweep/sweep_folder.hpp"

namespace bagnold::sweep {

/// A mean with its standard error at every point, [P] each; NaN if there is none.
struct Column {
  std::string name;  ///< of the observable
  std::vector<double> mean, error;
  std::vector<double> bias = {}, bias_error = {};  ///< of the method; empty where none was measured
};

/// Averages of the pieces of sequences and of the stresses of lists, a row a piece of each point.
struct PieceRows {
  std::vector<std::size_t> point;  ///< [rows]
  std::vector<double> piece;       ///< [rows], its number in the list, from 1
  std::vector<Column> columns;     ///< [rows] each; those of its place have no errors
};

/// Results of the points of a sweep.
struct Results {
  std::vector<Column> columns;  ///< every observable of any point, in the order of first appearance
  std::vector<std::string> status;        ///< [P]: "done", "failed" (begun, no result) or "open"
  std::vector<std::string> warnings;      ///< [P]: names of a point's warnings, a space between
  std::vector<std::string> notes;         ///< [P]: names of a point's notes, a space between
  std::vector<std::string> rough_errors;  ///< [P]: NAMEs whose errors are rough, a space between
  std::vector<double> strain;  ///< [P]: shear.strain of a point that is done, else NaN; of one that
                               ///< was made longer by itself more than the sweep says
  PieceRows pieces = {};       ///< of points that are sequences or hold a list of stresses
};

/// Reads the points' summary.json. Throws FileError if one cannot be read.
Results read_results(Sweep const& sweep, SweepFolder const& folder);

/// Sweep with the strain that its points have reached.
Sweep as_run(Sweep sweep, Results const& results);

/// Writes sweep.csv: a row a point, with the varied keys, NAME and NAME_error, where
/// measured NAME_bias and NAME_bias_error, rough_errors, warnings, notes, folder; cells are empty
/// if there is no value. Replaces the file as a whole; throws FileError.
void write_csv(std::filesystem::path const& file, Sweep const& sweep, Results const& results);

/// Writes pieces.csv: a row a piece, with the varied keys, its number and place, NAME and
/// NAME_error, folder. Replaces the file as a whole; throws FileError.
void write_pieces_csv(std::filesystem::path const& file, Sweep const& sweep,
                      PieceRows const& pieces);

/// Writes sweep.h5, see docs/files.md; `made_by` goes to the root. Replaces the file; throws
/// FileError.
void write_hdf5(std::filesystem::path const& file, Sweep const& sweep, Results const& results,
                io::Attributes const& made_by);

}  // namespace bagnold::sweep
