// SPDX-License-Identifier: BSD-3-Clause
#include "src/sweep/collect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "src/run/messages.hpp"
#include "src/run/provenance.hpp"

namespace bagnold::sweep {

SweepEnd write_tables(Sweep const& sweep, SweepFolder const& folder, SweepMonitor& monitor) {
  auto const results = read_results(sweep, folder);
  Provenance const made = provenance();
  write_csv(folder.table(), sweep, results);
  write_hdf5(folder.path() / "sweep.h5", sweep, results,
             {{"bagnold_version", made.version}, {"git", made.git}});
  monitor.collected(sweep, folder, results);
  auto const done = std::ranges::count(results.status, "done");
  auto const points = std::ssize(sweep.points);
  if (done == points) return SweepEnd::done;
  say(
      fmt::format("{} of {} points have no result: their rows are empty; the same sweep "
                  "without --collect tries them again",
                  points - done, points));
  return SweepEnd::incomplete;
}

std::string suspect_points(Sweep const& sweep, Results const& results) {
  std::map<std::string, int> points;  // by name of the warning
  for (auto const& names : results.warnings) {
    std::istringstream words(names);
    for (std::string name; words >> name;) ++points[name];
  }
  auto const suspect =
      std::ranges::count_if(results.warnings, [](auto const& names) { return !names.empty(); });
  if (suspect == 0) return {};
  std::string list;
  for (auto const& [name, count] : points)
    list += fmt::format("{}{} ({})", list.empty() ? "" : ", ", name, count);
  return fmt::format("{} of {} points are suspect: {}; see warnings in their summary.json", suspect,
                     sweep.points.size(), list);
}

}  // namespace bagnold::sweep
