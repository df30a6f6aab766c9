// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/trajectory_parts.hpp"

#include <regex>

namespace bagnold::io {

namespace fs = std::filesystem;

std::vector<fs::path> entries(fs::path const& folder, std::string const& pattern) {
  std::regex const name(pattern);
  std::vector<fs::path> found;
  std::error_code none_there;
  for (fs::directory_iterator file(folder, none_there), end; !none_there && file != end;
       file.increment(none_there))
    if (std::regex_match(file->path().filename().string(), name)) found.push_back(file->path());
  return found;
}

std::vector<fs::path> trajectory_parts(fs::path const& folder) {
  return entries(folder, "trajectory(_[0-9]+)?[.]parts");
}

bool run_finished(fs::path const& folder) {
  std::error_code ignored;
  return fs::exists(folder / "summary.json", ignored) && trajectory_parts(folder).empty();
}

}  // namespace bagnold::io
