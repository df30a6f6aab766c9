// SPDX-License-Identifier: BSD-3-Clause
#include "src/sweep/collect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "src/config/shell_word.hpp"
#include "src/run/messages.hpp"
#include "src/run/provenance.hpp"

namespace bagnold::sweep {

namespace {

/// The command that goes on with a sweep.
std::string command_of(Sweep const& sweep, std::filesystem::path const& folder) {
  return fmt::format("bagnold {} {}{} --out {}", sweep.command, shell_word(sweep.origin),
                     sweep.options, shell_word(folder.string()));
}

}  // namespace

SweepEnd write_tables(Sweep const& asked, SweepFolder const& folder, SweepMonitor& monitor) {
  auto const results = read_results(asked, folder);
  auto const sweep = as_run(asked, results);
  Provenance const made = provenance();
  write_csv(folder.table(), sweep, results);
  write_hdf5(folder.path() / "sweep.h5", sweep, results,
             {{"bagnold_version", made.version}, {"git", made.git}});
  if (!results.pieces.point.empty())
    write_pieces_csv(folder.path() / "pieces.csv", sweep, results.pieces);
  monitor.collected(sweep, folder, results);
  auto const done = std::ranges::count(results.status, "done");
  auto const points = std::ssize(sweep.points);
  if (done == points) return SweepEnd::done;
  say(fmt::format("{} of {} points have no result: their rows are empty; `{}` tries them again",
                  points - done, points, command_of(sweep, folder.path())));
  return SweepEnd::incomplete;
}

namespace {

/// Number of points that have each name.
std::map<std::string, int> counts_of(std::vector<std::string> const& lists) {
  std::map<std::string, int> points;
  for (auto const& names : lists) {
    std::istringstream words(names);
    for (std::string name; words >> name;) ++points[name];
  }
  return points;
}

/// "12 of 40 points are suspect: steady_state (10), error_bar (2)"; "" where no list has a name.
std::string counted_points(std::vector<std::string> const& lists, char const* what) {
  auto const some = std::ranges::count_if(lists, [](auto const& names) { return !names.empty(); });
  if (some == 0) return {};
  std::string names;
  for (auto const& [name, count] : counts_of(lists))
    names += fmt::format("{}{} ({})", names.empty() ? "" : ", ", name, count);
  return fmt::format("{} of {} points {}: {}", some, lists.size(), what, names);
}

}  // namespace

std::string suspect_points(Sweep const& sweep, Results const& results,
                           std::filesystem::path const& folder) {
  auto text = counted_points(results.warnings, "are suspect");
  if (text.empty()) return text;
  text += "; which, and why: column warnings of sweep.csv, and the points' summary.json";
  auto const names = counts_of(results.warnings);
  bool const by_option = sweep.options.find("shear.strain=") != std::string::npos;
  for (auto const* short_run : {"steady_state", "error_bar", "few_collisions", "contact_durations"})
    if (names.contains(short_run))
      return text + fmt::format(
                        "; raise shear.strain in {}, and `{}` goes on with points from which no "
                        "other starts",
                        by_option ? "--set" : sweep.origin, command_of(sweep, folder));
  return text;
}

std::string noted_points(Results const& results) {
  auto text = counted_points(results.notes, "have notes");
  return text.empty() ? text : text + "; see notes in their summary.json, docs/stability.md";
}

}  // namespace bagnold::sweep
