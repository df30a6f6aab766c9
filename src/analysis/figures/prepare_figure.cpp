// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/figures/prepare_figure.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "src/config/errors.hpp"
#include "src/sweep/checked_sweep.hpp"

namespace bagnold::analysis {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

/// A key of the file that is missing, or of another type.
[[noreturn]] void throw_malformed(std::string const& figure, json::exception const& error) {
  throw InputError(
      fmt::format("the file of figures: {} {}; see docs/figures.md", figure, error.what()));
}

/// Reads a figure and checks that its analyses and sweep files exist.
Figure read_checked(FigureFile const& file, std::string const& name, bool quick,
                    ReadWords const& read) {
  auto figure = file.read(name, quick);
  for (auto const* entries : {&figure.panels, &figure.stated})
    for (auto const& entry : *entries)
      if (entry.contains("analyse")) kind_of(read(entry.at("analyse"), name).kind);
  for (auto const& data : figure.data)
    if (!fs::exists(file.sweep(data)))
      throw InputError(
          fmt::format("{}: data = \"{}\": there is no {}", name, data, file.sweep(data).string()));
  return figure;
}

/// Runs the sweeps of a figure that are not done, until one is stopped.
sweep::SweepEnd run_sweeps(FigureFile const& file, Figure const& figure, DataFolder const& data,
                           sweep::SweepOptions const& options) {
  auto worst = sweep::SweepEnd::done;
  for (auto const& name : figure.data) {
    auto const sweep = sweep::read_checked_sweep(file.sweep(name));
    worst = std::max(worst, sweep::run(sweep, data.sweep(name), options));
    if (worst == sweep::SweepEnd::stopped) break;
  }
  return worst;
}

}  // namespace

PreparedFigure prepare_figure(fs::path const& path, FigureRequest const& request) try {
  FigureFile const file(path);
  PreparedFigure made{read_checked(file, request.name, request.quick, request.read),
                      sweep::SweepEnd::done,
                      {},
                      request.out / (request.name + (request.quick ? "-quick.png" : ".png")),
                      {}};
  bool const tables = !request.data.empty();
  DataFolder const data{tables ? request.data : request.out / "data", tables};
  if (tables)
    check_tables(made.figure, data);
  else
    made.sweeps = run_sweeps(file, made.figure, data, request.sweeps);
  if (made.sweeps == sweep::SweepEnd::stopped) return made;
  FigureMaker maker(made.figure, request.out / request.name, data, request.read);
  made.recipe = maker.write_recipe();
  made.stated = maker.compare_stated();
  return made;
} catch (json::exception const& error) {
  throw_malformed(request.name, error);
}

void list_figures(fs::path const& path, ReadWords const& read,
                  std::function<void(Figure const&, bool)> const& show) try {
  FigureFile const file(path);
  for (auto const& name : file.names()) {
    auto const figure = read_checked(file, name, false, read);
    if (file.has_quick(name)) read_checked(file, name, true, read);
    show(figure, file.has_quick(name));
  }
} catch (json::exception const& error) {
  throw_malformed("", error);
}

}  // namespace bagnold::analysis
