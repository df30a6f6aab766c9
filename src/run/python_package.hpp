// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace bagnold {

/// Folder that holds the Python package `bagnold`, which draws, exports and imports: the one that
/// BAGNOLD_PYTHON_PACKAGE names by its absolute path; else share/bagnold/python of the build tree
/// or the prefix that the running program lies in; else, for programs of users that are linked to
/// the libraries, of the prefix that was configured or that of the `bagnold` in PATH.
/// Empty: none of these, and the interpreter's own (pip install) is tried.
///
/// Nothing is looked for in the folder where the user stands.
std::filesystem::path python_package();

/// Why BAGNOLD_PYTHON_PACKAGE is of no use, and what to do; empty: it is not set, or good.
std::string wrong_python_package();

/// What became of a call of the package.
struct PythonCall {
  bool started = false;  ///< a Python with the package ran
  int code = 127;        ///< its exit code
  std::string errors;    ///< what it wrote to stderr; of much the end
};

/// Runs `python -m bagnold WORDS` with one of pythons() in isolated mode (-I), in a folder that
/// only the system's owner writes to, so that neither Python nor matplotlib takes code or settings
/// from where the user stands: paths in `words` are absolute. Its stdout is thrown away if `quiet`,
/// its stderr is kept.
PythonCall call_python(std::filesystem::path const& python, std::vector<std::string> const& words,
                       bool quiet);

/// Why a call failed: "PYTHON says: LINE" with the last line that it wrote to stderr, which names
/// the exception where there was one; without a line how it ended.
std::string reason_of(std::filesystem::path const& python, PythonCall const& call);

/// Runs `python -m bagnold WORDS` with the first of pythons() that can, its output shown; returns
/// its exit code. `wish`: what was to be done, in messages. Throws FileError where none can.
int call_package(std::vector<std::string> const& words, std::string const& wish);

}  // namespace bagnold
