// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "src/io/atomic_file.hpp"
#include "src/sweep/results.hpp"

namespace bagnold::sweep {

namespace {

std::string cell(std::string const& text) {  // RFC 4180
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (char const c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string cell(double value) { return std::isfinite(value) ? fmt::format("{}", value) : ""; }

}  // namespace

void write_csv(std::filesystem::path const& file, Sweep const& sweep, Results const& results) {
  std::vector<std::string> line;
  for (auto const& key : sweep.keys) line.push_back(cell(key));
  for (auto const& column : results.columns) {
    line.push_back(cell(column.name));
    line.push_back(cell(column.name + "_error"));
    if (column.bias.empty()) continue;
    line.push_back(cell(column.name + "_bias"));
    line.push_back(cell(column.name + "_bias_error"));
  }
  line.insert(line.end(), {"rough_errors", "warnings", "notes", "folder"});
  auto table = fmt::format("{}\n", fmt::join(line, ","));
  for (std::size_t k = 0; k < sweep.points.size(); ++k) {
    line.clear();
    for (auto const& value : sweep.points[k].values) line.push_back(cell(text_of(value)));
    for (auto const& column : results.columns) {
      line.push_back(cell(column.mean[k]));
      line.push_back(cell(column.error[k]));
      if (column.bias.empty()) continue;
      line.push_back(cell(column.bias[k]));
      line.push_back(cell(column.bias_error[k]));
    }
    line.push_back(cell(results.rough_errors[k]));
    line.push_back(cell(results.warnings[k]));
    line.push_back(cell(results.notes[k]));
    line.push_back(cell(sweep.points[k].folder));
    table += fmt::format("{}\n", fmt::join(line, ","));
  }
  io::replace_file(file, std::as_bytes(std::span(table)));
}

void write_pieces_csv(std::filesystem::path const& file, Sweep const& sweep,
                      PieceRows const& pieces) {
  std::vector<std::string> line;
  for (auto const& key : sweep.keys) line.push_back(cell(key));
  line.emplace_back("piece");
  auto const has_errors = [](Column const& column) {
    return std::ranges::any_of(column.error, [](double error) { return std::isfinite(error); });
  };
  for (auto const& column : pieces.columns) {
    line.push_back(cell(column.name));
    if (has_errors(column)) line.push_back(cell(column.name + "_error"));
  }
  line.emplace_back("folder");
  auto table = fmt::format("{}\n", fmt::join(line, ","));
  for (std::size_t row = 0; row < pieces.point.size(); ++row) {
    auto const& point = sweep.points[pieces.point[row]];
    line.clear();
    for (auto const& value : point.values) line.push_back(cell(text_of(value)));
    line.push_back(cell(pieces.piece[row]));
    for (auto const& column : pieces.columns) {
      line.push_back(cell(column.mean[row]));
      if (has_errors(column)) line.push_back(cell(column.error[row]));
    }
    line.push_back(cell(point.folder));
    table += fmt::format("{}\n", fmt::join(line, ","));
  }
  io::replace_file(file, std::as_bytes(std::span(table)));
}

}  // namespace bagnold::sweep
