// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "src/io/hdf5_writer.hpp"
#include "src/statistics/tables.hpp"

namespace bagnold::io {

/// One value a window, of each replica.
struct Series {
  std::string name;           ///< of the dataset
  std::string unit;           ///< e.g. "1/tau_e"; "1" for pure numbers
  std::string description;    ///< one sentence
  std::vector<double> value;  ///< [R][n]
};

/// Content of `result.h5`, see docs/files.md.
struct Result {
  Attributes attributes;  ///< of the file root: provenance and the resolved scene
  std::vector<Series> series;
  std::int64_t discarded_windows = 0;  ///< first windows that no average uses
  std::string axis = "strain";         ///< the series over which a single system has the others
  std::size_t replicas = 1;            ///< R; where it is 1 the series have no such axis
  std::vector<statistics::Histogram> histograms = {};
  std::vector<statistics::Profile> profiles = {};
  std::vector<statistics::Samples> samples = {};
};

/// Replaces the file as a whole; equal results give equal bytes. Throws FileError.
void write_result(std::filesystem::path const& path, Result const& result);

}  // namespace bagnold::io
