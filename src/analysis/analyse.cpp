// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/analyse.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "src/analysis/curves.hpp"
#include "src/config/errors.hpp"
#include "src/io/atomic_file.hpp"

namespace bagnold::analysis {

namespace {

struct Option {
  std::string_view name;
  bool (*is_given)(Request const& request);  ///< as something else than by default
};
/// Options that not every kind uses.
constexpr Option options_of_kinds[] = {
    {"--fix", [](Request const& r) { return !r.fixed.empty(); }},
    {"--of", [](Request const& r) { return r.of != Request{}.of; }},
    {"--weigh", [](Request const& r) { return r.weigh != Request{}.weigh; }},
    {"--kinks", [](Request const& r) { return r.kinks != Request{}.kinks; }},
    {"--curved", [](Request const& r) { return r.curved; }},
    {"--direction", [](Request const& r) { return r.direction != Request{}.direction; }},
    {"--least-factor", [](Request const& r) { return r.least_factor != Request{}.least_factor; }},
    {"--rates", [](Request const& r) { return !r.rates.empty(); }},
    {"--split", [](Request const& r) { return r.split.has_value(); }},
    {"--pressure", [](Request const& r) { return r.pressure.has_value(); }},
    {"--window", [](Request const& r) { return r.window != Request{}.window; }},
    {"--log-x", [](Request const& r) { return r.log_x; }},
    {"--log-y", [](Request const& r) { return r.log_y; }},
};

/// True if an option is among those that matter to a kind.
bool names(Kind const& kind, std::string_view option) {
  return kind.options.find(option) != std::string_view::npos;
}

/// A divergence uses the options of the kind that its places come from, too.
bool uses(Kind const& kind, Request const& request, std::string_view option) {
  if (names(kind, option)) return true;
  auto const places = std::ranges::find(kinds(), request.of, &Kind::name);
  return names(kind, "--of") && places != kinds().end() && names(*places, option);
}

void refuse_unused(Kind const& kind, Request const& request) {
  for (auto const& option : options_of_kinds) {
    if (!option.is_given(request) || uses(kind, request, option.name)) continue;
    std::vector<std::string_view> users;
    for (auto const& other : kinds())
      if (names(other, option.name)) users.push_back(other.name);
    throw InputError(fmt::format("{} (no option of {} but of {}); leave it out", option.name,
                                 kind.name, fmt::join(users, ", ")));
  }
}

/// A refusal for want of points says how many were left out.
Report run_kind(Kind const& kind, SweepTable const& table, Request const& request) try {
  if (auto const& range = request.range; range && !(range->first < range->second))
    throw InputError(
        fmt::format("--range {} {} (LOW HIGH: must rise)", range->first, range->second));
  refuse_unused(kind, request);
  auto report = kind.run(table, request);
  if (auto note = mixed_data(table, request.where); !note.empty())
    report.notes.push_back(std::move(note));
  return report;
} catch (InputError const& error) {
  if (table.left_out().empty()) throw;
  throw InputError(fmt::format("{}; {}", error.what(), table.left_out()));
}

/// Folder of a sweep, from it or from a file in it.
std::filesystem::path folder_of(std::filesystem::path const& sweep) {
  return std::filesystem::is_directory(sweep) ? sweep : sweep.parent_path();
}

/// Throws InputError where a file to be written is one that was read, or a table of a sweep beside
/// it.
void refuse_inputs(std::vector<std::filesystem::path> const& sweeps,
                   std::filesystem::path const& written) {
  for (auto const& sweep : sweeps)
    for (auto const& kept :
         {sweep, folder_of(sweep) / "sweep.csv", folder_of(sweep) / "pieces.csv"}) {
      std::error_code not_there;
      if (std::filesystem::equivalent(kept, written, not_there))
        throw InputError(
            fmt::format("{}: holds what is analysed; give another --out", written.string()));
    }
}

std::filesystem::path with_ending(std::filesystem::path path, char const* ending) {
  return path += ending;
}

}  // namespace

Analysis analyse(std::vector<std::filesystem::path> const& sweeps, KindRequest const& asked,
                 std::filesystem::path prefix) {
  auto const& kind = kind_of(asked.kind);
  std::vector<SweepTable> tables;
  for (auto const& sweep : sweeps) tables.push_back(read_sweep_table(sweep));
  auto const table = merge_tables(std::move(tables));
  auto const& sweep = sweeps.front();
  if (prefix.empty())
    prefix = folder_of(sweep) / asked.kind;
  else if (prefix.filename().empty())
    prefix /= asked.kind;
  for (auto const* ending : {".csv", ".drawn.csv"})
    refuse_inputs(sweeps, with_ending(prefix, ending));
  auto report = run_kind(kind, table, asked.request);
  if (!prefix.parent_path().empty()) std::filesystem::create_directories(prefix.parent_path());
  Analysis made{&kind, std::move(report), with_ending(prefix, ".csv"),
                with_ending(prefix, ".drawn.csv"), with_ending(prefix, ".png")};
  io::replace_text(made.results, to_csv(made.report.results));
  io::replace_text(made.drawn, to_csv(made.report.drawn));
  return made;
}

}  // namespace bagnold::analysis
