// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace bagnold {

/// Folder that holds the Python package `bagnold`, which draws, exports and imports. If
/// BAGNOLD_PYTHON_PACKAGE is set, it is the only candidate (an absolute path). Otherwise the first
/// that exists is taken of
///
/// - share/bagnold/python of the build tree or the prefix of the running program;
/// - for users' programs linked to the libraries, that of the configured prefix;
/// - that of the prefix of the `bagnold` in PATH.
///
/// Empty if there is none; then the interpreter's own (pip install) is tried. Nothing is searched
/// in the user's working directory.
std::filesystem::path python_package();

/// Reason why BAGNOLD_PYTHON_PACKAGE cannot be used, and what to do; empty if it is not set, or
/// valid.
std::string wrong_python_package();

/// Outcome of a call of the package.
struct PythonCall {
  bool started = false;  ///< a Python with the package ran
  int code = 127;        ///< its exit code
  std::string errors;    ///< what it wrote to stderr; of much the end
};

/// Runs `python -m bagnold WORDS` with one of pythons() in isolated mode (-I), in a folder that
/// only the system's owner can write to, so that neither Python nor matplotlib takes code or
/// settings from the working directory: paths in `words` are absolute. Its stdout is discarded if
/// `quiet`, its stderr is kept.
PythonCall call_python(std::filesystem::path const& python, std::vector<std::string> const& words,
                       bool quiet);

/// Reason of a failure: "PYTHON says: LINE" with the last line that it wrote to stderr, which names
/// the exception if there was one; without a line, how it ended.
std::string reason_of(std::filesystem::path const& python, PythonCall const& call);

/// Runs `python -m bagnold WORDS` with the first of pythons() that can, its output shown; returns
/// its exit code. `wish`: the task, for messages. Throws FileError if none can.
int call_package(std::vector<std::string> const& words, std::string const& wish);

}  // namespace bagnold
