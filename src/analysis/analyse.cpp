// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/analyse.hpp"

#include "src/io/atomic_file.hpp"

namespace bagnold::analysis {

namespace {

std::filesystem::path with_ending(std::filesystem::path path, char const* ending) {
  return path += ending;
}

}  // namespace

Analysis analyse(std::filesystem::path const& sweep, KindRequest const& asked,
                 std::filesystem::path prefix) {
  auto const& kind = kind_of(asked.kind);
  auto report = kind.run(read_sweep_table(sweep), asked.request);
  if (prefix.empty())
    prefix = (std::filesystem::is_directory(sweep) ? sweep : sweep.parent_path()) / asked.kind;
  if (!prefix.parent_path().empty()) std::filesystem::create_directories(prefix.parent_path());
  Analysis made{&kind, std::move(report), with_ending(prefix, ".csv"),
                with_ending(prefix, ".drawn.csv"), with_ending(prefix, ".png")};
  io::replace_text(made.results, to_csv(made.report.results));
  io::replace_text(made.drawn, to_csv(made.report.drawn));
  return made;
}

}  // namespace bagnold::analysis
