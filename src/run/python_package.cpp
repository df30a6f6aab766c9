// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/python_package.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>

#include "src/config/errors.hpp"
#include "src/run/pythons.hpp"

namespace bagnold {

namespace fs = std::filesystem;

namespace {

/// The folder of the package, "" for the interpreter's own, is the first word.
constexpr char const* main_of_package =
    "import sys\n"
    "folder = sys.argv.pop(1)\n"
    "if folder: sys.path.insert(0, folder)\n"
    "try:\n"
    "    from bagnold.__main__ import main\n"
    "except ImportError as error:\n"
    "    print(f'bagnold: {error}', file=sys.stderr)\n"
    "    sys.exit(127)\n"
    "sys.exit(main())\n";

bool holds_package(fs::path const& folder) {
  std::error_code ignored;
  return folder.is_absolute() && fs::exists(folder / "bagnold/__main__.py", ignored);
}

}  // namespace

fs::path python_package() {
  if (char const* const chosen = std::getenv("BAGNOLD_PYTHON_PACKAGE"))
    return holds_package(chosen) ? fs::path(chosen) : fs::path();
  std::error_code ignored;
  auto const program = fs::read_symlink("/proc/self/exe", ignored).parent_path();
  for (auto const& folder :
       {program / "share/bagnold/python", program / "../share/bagnold/python",
        fs::path(BAGNOLD_INSTALLED_PYTHON),
        fs::canonical(in_path("bagnold"), ignored).parent_path() / "../share/bagnold/python"})
    if (holds_package(folder)) return folder.lexically_normal();
  return {};
}

std::string wrong_python_package() {
  char const* const chosen = std::getenv("BAGNOLD_PYTHON_PACKAGE");
  if (chosen == nullptr || holds_package(chosen)) return {};
  return fmt::format(
      "BAGNOLD_PYTHON_PACKAGE = {} (must be the absolute path of a folder that holds bagnold/, as "
      "share/bagnold/python of an installed Bagnold); mend it or take it out of the environment",
      chosen);
}

PythonCall call_python(fs::path const& python, std::vector<std::string> const& words, bool quiet) {
  std::vector<std::string> line{python, "-I", "-B", "-c", main_of_package, python_package()};
  line.insert(line.end(), words.begin(), words.end());
  std::vector<char*> arguments;
  for (auto& word : line) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t const child = fork();
  if (child < 0) return {};
  if (child == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);  // no picture of a folder that another process may take over
    int const nowhere = open("/dev/null", O_RDWR);
    dup2(nowhere, STDIN_FILENO);
    if (quiet) {
      dup2(nowhere, STDOUT_FILENO);
      dup2(nowhere, STDERR_FILENO);
    }
    if (chdir("/") == 0) execv(python.c_str(), arguments.data());
    _exit(127);
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  int const code = WIFEXITED(status) ? WEXITSTATUS(status) : 126;
  return {code != 127, code};
}

int call_package(std::vector<std::string> const& words, std::string const& wish) {
  if (auto const wrong = wrong_python_package(); !wrong.empty())
    throw FileError(fmt::format("cannot {}: {}", wish, wrong));
  for (auto const& python : pythons())
    if (auto const call = call_python(python, words, false); call.started) return call.code;
  throw FileError(fmt::format(
      "cannot {}: python3 with numpy and h5py is needed; BAGNOLD_PYTHON may name one, by its "
      "absolute "
      "path, and BAGNOLD_PYTHON_PACKAGE the folder of the package, share/bagnold/python",
      wish));
}

}  // namespace bagnold
