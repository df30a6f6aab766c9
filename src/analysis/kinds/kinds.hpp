// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string_view>

#include "src/analysis/panel.hpp"
#include "src/analysis/report.hpp"
#include "src/analysis/request.hpp"
#include "src/analysis/sweep_table.hpp"

namespace bagnold::analysis {

/// A kind of analysis, as the command line offers it.
struct Kind {
  std::string_view name;
  std::string_view equation;
  std::string_view source;   ///< paper, equation, figures
  std::string_view options;  ///< those that matter to it
  Report (*run)(SweepTable const&, Request const&);
};

/// All kinds. Each run throws InputError where nothing can be found.
std::span<Kind const> kinds();

/// Kind of that name; throws InputError with the nearest name.
Kind const& kind_of(std::string_view name);

Report crossover(SweepTable const& table, Request const& request);
Report divergence(SweepTable const& table, Request const& request);
Report friction_law(SweepTable const& table, Request const& request);
Report exponents(SweepTable const& table, Request const& request);
Report transition(SweepTable const& table, Request const& request);
Report kink(SweepTable const& table, Request const& request);
Report jump(SweepTable const& table, Request const& request);
Report peak(SweepTable const& table, Request const& request);
Report constant_pressure(SweepTable const& table, Request const& request);
Report merged_table(SweepTable const& table, Request const& request);

// Where a crossover, a jump or a transition lies, for each curve: value = {place, ...}, but
// {C, place, s, q} of a crossover. The series that they were found on are put into `series`.
inline constexpr std::size_t crossover_place = 1;
inline std::vector<std::string> const crossover_names{"C", "Q_star", "s", "q"};
std::vector<Outcome> find_crossovers(SweepTable const& table, Request const& request,
                                     std::vector<Series>& series);
std::vector<Outcome> find_jumps(SweepTable const& table, Request const& request,
                                std::vector<Series>& series);
std::vector<Outcome> find_transitions(SweepTable const& table, Request const& request,
                                      std::vector<Series>& series);

/// Throws InputError unless --direction is up, down or both.
void check_direction(Request const& request);

/// True for quantities on x that cover decades, such as Q and the rate: a packing fraction does
/// not.
inline bool covers_decades(std::string const& x) {
  return x != "disks.packing_fraction" && x != "packing_fraction";
}

/// `given`, or the kind's own where it is empty.
inline std::string or_else(std::string const& given, std::string const& own) {
  return given.empty() ? own : given;
}

}  // namespace bagnold::analysis
