// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/scene_file.hpp"
#include "src/io/atomic_file.hpp"
#include "src/sweep/results.hpp"

namespace bagnold::sweep {

namespace {

/// Doubles where every value of the key is a number, texts otherwise.
void write_key(io::Hdf5Writer& file, Sweep const& sweep, std::size_t key) {
  auto const path = "/points/" + sweep.keys[key];
  std::vector<double> numbers;
  std::vector<std::string> texts;
  for (auto const& point : sweep.points) {
    if (auto const* number = std::get_if<double>(&point.values[key])) numbers.push_back(*number);
    texts.push_back(text_of(point.values[key]));
  }
  if (numbers.size() == texts.size())
    file.dataset(path, numbers, {numbers.size()});
  else
    file.texts(path, texts);
}

}  // namespace

void write_hdf5(std::filesystem::path const& path, Sweep const& sweep, Results const& results,
                io::Attributes const& made_by) {
  io::Hdf5Writer file;
  file.attribute("/", "schema", std::int64_t{1});
  file.attribute("/", "scene", sweep.base);
  file.attribute("/", "sweep", sweep.text);
  for (auto const& [name, value] : made_by) file.attribute("/", name, value);

  file.group("/points");
  for (std::size_t key = 0; key < sweep.keys.size(); ++key) write_key(file, sweep, key);
  std::vector<std::string> folders, scenes;
  for (auto const& point : sweep.points) {
    folders.push_back(point.folder);
    scenes.push_back(write_scene(point.scene));
  }
  file.texts("/points/folder", folders);
  file.texts("/points/scene", scenes);
  file.texts("/status", results.status);
  file.texts("/warnings", results.warnings);
  file.texts("/notes", results.notes);
  file.texts("/rough_errors", results.rough_errors);

  file.group("/observables");
  auto const points = sweep.points.size();
  for (auto const& column : results.columns) {
    file.dataset("/observables/" + column.name, column.mean, {points});
    file.dataset("/observables/" + column.name + "_error", column.error, {points});
    if (column.bias.empty()) continue;
    file.dataset("/observables/" + column.name + "_bias", column.bias, {points});
    file.dataset("/observables/" + column.name + "_bias_error", column.bias_error, {points});
  }
  if (auto const& pieces = results.pieces; !pieces.point.empty()) {
    auto const rows = pieces.point.size();
    file.group("/pieces");
    file.dataset("/pieces/point", std::vector<double>(pieces.point.begin(), pieces.point.end()),
                 {rows});
    file.dataset("/pieces/piece", pieces.piece, {rows});
    for (auto const& column : pieces.columns) {
      file.dataset("/pieces/" + column.name, column.mean, {rows});
      file.dataset("/pieces/" + column.name + "_error", column.error, {rows});
    }
  }
  io::replace_file(path, file.content());
}

}  // namespace bagnold::sweep
