// SPDX-License-Identifier: BSD-3-Clause
#include "src/sweep/results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "src/config/errors.hpp"
#include "src/io/atomic_file.hpp"

namespace bagnold::sweep {

namespace {

using Json = nlohmann::ordered_json;
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

double number(Json const& object, char const* name) {
  auto const found = object.find(name);
  return found != object.end() && found->is_number() ? found->get<double>() : nothing;
}

bool is_true(Json const& object, char const* name) {
  auto const found = object.find(name);
  return found != object.end() && *found == true;
}

Json read_summary(std::filesystem::path const& summary) {
  auto const bytes = io::read_file(summary);
  auto const* text = reinterpret_cast<char const*>(bytes.data());
  Json const all = Json::parse(text, text + bytes.size(), nullptr, /*allow_exceptions=*/false);
  if (!all.is_object() || !all.contains("observables") || !all["observables"].is_object())
    throw FileError(fmt::format("{}: has no observables; remove the point's folder to run it again",
                                summary.string()));
  return all;
}

void append(std::string& names, std::string const& name) {
  names += (names.empty() ? "" : " ") + name;
}

/// Names in its "warnings" or "notes".
std::string names_in(Json const& summary, char const* list) {
  std::string names;
  for (auto const& warning : summary.value(list, Json::array()))
    append(names, warning.value("name", ""));
  return names;
}

double strain_of(Json const& summary) {
  auto const at = Json::json_pointer("/scene/shear/strain");
  return summary.contains(at) && summary[at].is_number() ? summary[at].get<double>() : nothing;
}

Column& column(std::vector<Column>& columns, std::string const& name, std::size_t rows) {
  auto const found = std::ranges::find(columns, name, &Column::name);
  auto& of_name = found != columns.end() ? *found : columns.emplace_back(Column{name, {}, {}});
  of_name.mean.resize(rows, nothing);
  of_name.error.resize(rows, nothing);
  return of_name;
}

void add_bias(Json const& estimate, std::size_t point, std::size_t points, Column& of_name) {
  if (!estimate.contains("bias")) return;
  for (auto* column : {&of_name.bias, &of_name.bias_error}) column->resize(points, nothing);
  of_name.bias[point] = number(estimate, "bias");
  of_name.bias_error[point] = number(estimate, "bias_error");
}

/// Adds a row for each entry of a list of the summary; `places`: what an entry has besides
/// averages.
void add_rows(Json const& list, std::initializer_list<char const*> places, std::size_t point,
              PieceRows& rows) {
  double number_in_list = 0;
  for (auto const& piece : list) {
    rows.point.push_back(point);
    rows.piece.push_back(++number_in_list);
    auto const count = rows.point.size();
    for (auto const* place : places)
      column(rows.columns, place, count).mean.back() = number(piece, place);
    Json const averages = piece.value("observables", Json::object());
    for (auto const& [name, estimate] : averages.items()) {
      auto& of_name = column(rows.columns, name, count);
      of_name.mean.back() = number(estimate, "mean");
      of_name.error.back() = number(estimate, "error");
    }
  }
}

void read_pieces(Json const& summary, std::size_t point, PieceRows& rows) {
  add_rows(summary.value("pieces", Json::array()),
           {"strain_rate", "begin_strain", "strain", "begin_time", "time"}, point, rows);
  add_rows(summary.value("stresses", Json::array()), {"stress", "strain"}, point, rows);
}

}  // namespace

Results read_results(Sweep const& sweep, SweepFolder const& folder) {
  auto const points = sweep.points.size();
  Results results;
  results.warnings.resize(points);
  results.notes.resize(points);
  results.rough_errors.resize(points);
  results.strain.resize(points, nothing);
  for (std::size_t k = 0; k < points; ++k) {
    if (!folder.has_results(k)) {
      results.status.push_back(folder.begun(k) && !folder.in_use(k) ? "failed" : "open");
      continue;
    }
    results.status.push_back("done");
    Json const summary = read_summary(folder.summary(k));
    results.warnings[k] = names_in(summary, "warnings");
    results.notes[k] = names_in(summary, "notes");
    results.strain[k] = strain_of(summary);
    for (auto const& [name, estimate] : summary["observables"].items()) {
      auto& of_name = column(results.columns, name, points);
      of_name.mean[k] = number(estimate, "mean");
      of_name.error[k] = number(estimate, "error");
      add_bias(estimate, k, points, of_name);
      if (is_true(estimate, "rough")) append(results.rough_errors[k], name);
    }
    read_pieces(summary, k, results.pieces);
  }
  for (auto const& one : results.pieces.columns)  // all rows, those without it too
    column(results.pieces.columns, one.name, results.pieces.point.size());
  return results;
}

Sweep as_run(Sweep sweep, Results const& results) {
  auto const key = std::ranges::find(sweep.keys, "shear.strain") - sweep.keys.begin();
  for (std::size_t k = 0; k < sweep.points.size(); ++k) {
    auto& point = sweep.points[k];
    if (!(results.strain[k] > point.scene.shear.strain)) continue;
    point.scene.shear.strain = results.strain[k];
    if (key < std::ssize(sweep.keys))
      point.values[static_cast<std::size_t>(key)] = results.strain[k];
  }
  return sweep;
}

}  // namespace bagnold::sweep
