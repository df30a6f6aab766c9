// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/plot.hpp"

#include <cstdio>

#include "src/run/python_package.hpp"
#include "src/run/pythons.hpp"

namespace bagnold {

namespace fs = std::filesystem;

namespace {

/// True if a call failed because Python or its libraries are missing.
bool lacks_library(std::string const& reason) {
  for (auto const* words : {"No module named", "cannot be started", "ImportError"})
    if (reason.find(words) != std::string::npos) return true;
  return false;
}

/// Calls `python -m bagnold plot`, which selects the picture by the names. Tries the existing
/// Pythons; returns the failures, with the last line of each, or "". Errors of Python are shown
/// unless `quiet`.
std::string draw(fs::path const& data, fs::path const& target, bool quiet = true,
                 std::vector<std::string> const& options = {}) {
  if (auto const wrong = wrong_python_package(); !wrong.empty())
    return "no picture drawn: " + wrong;
  std::vector<std::string> words{"plot", fs::absolute(data), fs::absolute(target)};
  words.insert(words.end(), options.begin(), options.end());
  std::string failed, lacking;
  for (auto const& python : pythons()) {
    auto const call = call_python(python, words, quiet);
    if (call.code == 0) return "";
    if (!quiet && call.started) {
      std::fputs(call.errors.c_str(), stderr);
      return "no picture drawn, see above";
    }
    auto const reason = reason_of(python, call);
    auto& reasons = lacks_library(reason) ? lacking : failed;
    reasons += (reasons.empty() ? "" : "; ") + reason;
  }
  if (!failed.empty()) return "no picture drawn: " + failed;
  auto told = "no picture drawn: " + lacking + (lacking.empty() ? "" : "; ") +
              "python3 with h5py and matplotlib is needed (BAGNOLD_PYTHON may name one, by its "
              "absolute path; PYTHONPATH and packages of a user alone are not looked at)";
  if (python_package().empty())
    told +=
        "; the package that draws is not found either: BAGNOLD_PYTHON_PACKAGE may name its "
        "folder, share/bagnold/python, by its absolute path";
  return told;
}

}  // namespace

std::string draw_plot(std::filesystem::path const& result, std::filesystem::path const& picture) {
  return draw(result, picture);
}

std::string draw_frames(std::filesystem::path const& result, std::filesystem::path const& folder) {
  return draw(result, folder, true, {"--frames"});
}

std::string draw_figure(std::filesystem::path const& recipe, std::filesystem::path const& picture) {
  return draw(recipe, picture, false);
}

}  // namespace bagnold
