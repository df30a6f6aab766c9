// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/pythons.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <string>

namespace bagnold {

namespace fs = std::filesystem;

namespace {

bool is_program(fs::path const& file) {
  std::error_code ignored;
  return file.is_absolute() && fs::is_regular_file(file, ignored) &&
         access(file.c_str(), X_OK) == 0;
}

}  // namespace

fs::path in_path(std::string const& name) {
  char const* const path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (auto const program = fs::path(folder) / name; is_program(program)) return program;
  return {};
}

std::vector<fs::path> pythons() {
  std::vector<fs::path> found;
  if (char const* const chosen = std::getenv("BAGNOLD_PYTHON")) {
    found = {fs::path(chosen).has_parent_path() ? fs::path(chosen) : in_path(chosen)};
  } else {
    std::error_code ignored;
    auto const beside = fs::read_symlink("/proc/self/exe", ignored).parent_path() / "python3";
    if (is_program(beside)) found = {beside};
    for (auto const& python : {fs::path("/usr/bin/python3"), in_path("python3")})
      if (std::ranges::count(found, python) == 0) found.push_back(python);
  }
  std::erase_if(found, [](fs::path const& python) { return !python.is_absolute(); });
  return found;
}

}  // namespace bagnold
