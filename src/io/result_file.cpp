// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/result_file.hpp"

#include <fmt/format.h>

#include <numeric>

#include "src/io/atomic_file.hpp"

namespace bagnold::io {
namespace {

/// Shape of a dataset of n numbers for each of some frames.
Shape shape_of(std::vector<std::size_t> const& frames, std::size_t n) {
  Shape shape(frames.begin(), frames.end());
  shape.push_back(n);
  return shape;
}

void put(Hdf5Writer& file, statistics::Histogram const& h) {
  auto const at = "/histograms/" + h.name;
  file.group(at);
  file.attribute(at, "description", h.description);
  file.dataset(at + "/edges", h.edges, {h.edges.size()}, {{"unit", h.unit}});
  file.dataset(at + "/density", h.density, shape_of(h.frames, h.edges.size() - 1));
}

void put(Hdf5Writer& file, statistics::Profile const& p) {
  auto const at = "/profiles/" + p.name;
  file.group(at);
  file.attribute(at, "description", p.description);
  file.dataset(at + "/y", p.y, {p.y.size()}, {{"unit", "d_s"}});
  file.dataset(at + "/value", p.value, shape_of(p.frames, p.y.size()), {{"unit", p.unit}});
  if (!p.frames.empty()) return;
  file.dataset(at + "/error", p.error, {p.error.size()}, {{"unit", p.unit}});
}

void put(Hdf5Writer& file, statistics::Samples const& s) {
  auto const columns = s.columns.size();
  file.dataset(
      "/samples/" + s.name, s.rows, {s.rows.size() / columns, columns},
      {{"description", s.description}, {"columns", fmt::format("{}", fmt::join(s.columns, ", "))}});
}

/// Names the axes of all series, as netCDF and xarray read it: the strain, or where the shear
/// turns the time, is that of one system; of replicas it is a series of each, and seeds and windows
/// are counted.
void scale_series(Hdf5Writer& file, Result const& result) {
  std::vector<std::string> paths;
  bool found = false;
  for (auto const& series : result.series) {
    bool const is_scale = series.name == result.axis && result.replicas == 1;
    if (!is_scale) paths.push_back("/series/" + series.name);
    found = found || is_scale;
  }
  if (found) file.scale_axes({"/series/" + result.axis}, paths);
  if (result.replicas == 1 || paths.empty()) return;
  std::vector<std::int64_t> seed(result.replicas);
  std::iota(seed.begin(), seed.end(), 0);
  for (auto const& [name, value] : result.attributes)
    if (name == "seeds") seed = std::get<std::vector<std::int64_t>>(value);
  std::vector<std::int64_t> window(result.series.front().value.size() / result.replicas);
  std::iota(window.begin(), window.end(), 0);
  file.dataset("/seed", seed, {seed.size()}, {{"description", "of each replica"}});
  file.dataset("/window", window, {window.size()}, {{"description", "number, from 0"}});
  file.scale_axes({"/seed", "/window"}, paths);
}

/// A group with its tables, where there are any.
template <class Table>
void put_all(Hdf5Writer& file, std::string const& group, std::vector<Table> const& tables) {
  if (tables.empty()) return;
  file.group(group);
  for (auto const& table : tables) put(file, table);
}

}  // namespace

void write_result(std::filesystem::path const& path, Result const& result) {
  Hdf5Writer file;
  for (auto const& [name, value] : result.attributes) file.attribute("/", name, value);
  file.group("/series");
  file.attribute("/series", "discarded_windows", result.discarded_windows);
  for (auto const& series : result.series) {
    Shape shape{series.value.size() / result.replicas};
    if (result.replicas > 1) shape.insert(shape.begin(), result.replicas);
    file.dataset("/series/" + series.name, series.value, shape,
                 {{"unit", series.unit}, {"description", series.description}});
  }
  scale_series(file, result);
  put_all(file, "/histograms", result.histograms);
  put_all(file, "/profiles", result.profiles);
  put_all(file, "/samples", result.samples);
  replace_file(path, file.content());
}

}  // namespace bagnold::io
