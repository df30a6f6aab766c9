// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/python_package.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "src/config/errors.hpp"
#include "src/run/cores.hpp"
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

namespace {

constexpr std::size_t most_kept = 1 << 16;  // of stderr, bytes

/// Reads all output of a pipe; if it is long, keeps the end.
std::string read_all(int pipe) {
  std::string text;
  std::array<char, 4096> part{};
  for (;;) {
    auto const got = ::read(pipe, part.data(), part.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return text;
    text.append(part.data(), static_cast<std::size_t>(got));
    if (text.size() > most_kept) text.erase(0, text.size() - most_kept);
  }
}

/// Last nonempty line, fit for a terminal.
std::string last_line(std::string const& text) {
  constexpr auto no_word = " \t\r\n";
  auto const end = text.find_last_not_of(no_word);
  if (end == std::string::npos) return {};
  auto const before = text.find_last_of('\n', end);
  auto line = text.substr(before == std::string::npos ? 0 : before + 1);
  line.resize(line.find_last_not_of(no_word) + 1);
  for (auto& letter : line)
    if (static_cast<unsigned char>(letter) < ' ' || letter == '\x7f') letter = '?';
  return line;
}

}  // namespace

PythonCall call_python(fs::path const& python, std::vector<std::string> const& words, bool quiet) {
  std::vector<std::string> line{python, "-I", "-B", "-c", main_of_package, python_package()};
  line.insert(line.end(), words.begin(), words.end());
  std::vector<char*> arguments;
  for (auto& word : line) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  std::array<int, 2> pipe{};
  if (pipe2(pipe.data(), O_CLOEXEC) != 0) return {};
  pid_t const child = fork();
  if (child < 0) {
    close(pipe[0]);
    close(pipe[1]);
    return {};
  }
  if (child == 0) {
    use_all_cores();
    prctl(PR_SET_PDEATHSIG, SIGKILL);  // no picture of a folder that another process may take over
    dup2(pipe[1], STDERR_FILENO);
    fcntl(STDERR_FILENO, F_SETFD, 0);  // the pipe may have been it, where the program has no stderr
    int const nowhere = open("/dev/null", O_RDWR);
    dup2(nowhere, STDIN_FILENO);
    if (quiet) dup2(nowhere, STDOUT_FILENO);
    if (chdir("/") == 0) execv(python.c_str(), arguments.data());
    _exit(127);
  }
  close(pipe[1]);
  auto errors = read_all(pipe[0]);
  close(pipe[0]);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  int const code = WIFEXITED(status) ? WEXITSTATUS(status) : 126;
  if (WIFSIGNALED(status))
    errors += fmt::format("bagnold: Python was ended by signal {} ({})\n", WTERMSIG(status),
                          strsignal(WTERMSIG(status)));
  return {code != 127, code, std::move(errors)};
}

std::string reason_of(fs::path const& python, PythonCall const& call) {
  auto const line = last_line(call.errors);
  if (!line.empty()) return fmt::format("{} says: {}", python.string(), line);
  return call.started ? fmt::format("{} ended with code {}", python.string(), call.code)
                      : fmt::format("{} cannot be started", python.string());
}

int call_package(std::vector<std::string> const& words, std::string const& wish) {
  if (auto const wrong = wrong_python_package(); !wrong.empty())
    throw FileError(fmt::format("cannot {}: {}", wish, wrong));
  std::string reasons;
  for (auto const& python : pythons()) {
    auto const call = call_python(python, words, false);
    if (call.started) {
      std::fputs(call.errors.c_str(), stderr);
      return call.code;
    }
    reasons += reason_of(python, call) + "; ";
  }
  throw FileError(fmt::format(
      "cannot {}: {}python3 with numpy and h5py is needed; BAGNOLD_PYTHON may name one, by its "
      "absolute path, and BAGNOLD_PYTHON_PACKAGE the folder of the package, share/bagnold/python",
      wish, reasons));
}

}  // namespace bagnold
