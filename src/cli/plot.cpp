// SPDX-License-Identifier: BSD-3-Clause
#include "src/cli/plot.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "plot_analysis_script.hpp"
#include "plot_frames_script.hpp"
#include "plot_script.hpp"

namespace bagnold {

namespace {

/// Runs `python - data target` with the script on its standard input, its output thrown away.
/// Returns its exit code; 127 if it cannot be started.
int run_script(std::string const& python, char const* script, std::string const& data,
               std::string const& target) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) return 127;
  pid_t const child = fork();
  if (child < 0) return 127;
  if (child == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);  // no picture of a folder that another process may take over
    int const nowhere = open("/dev/null", O_WRONLY);
    dup2(ends[0], STDIN_FILENO);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    execlp(python.c_str(), python.c_str(), "-", data.c_str(), target.c_str(),
           static_cast<char*>(nullptr));
    _exit(127);
  }
  close(ends[0]);
  for (std::size_t sent = 0, size = std::strlen(script); sent < size;) {
    ssize_t const now = write(ends[1], script + sent, size - sent);
    if (now <= 0) break;
    sent += static_cast<std::size_t>(now);
  }
  close(ends[1]);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 126;
}

/// Tries the Pythons there are; what went wrong, or "".
std::string draw(char const* script, std::filesystem::path const& data,
                 std::filesystem::path const& target) {
  std::vector<std::string> pythons{"/usr/bin/python3", "python3"};
  if (char const* chosen = std::getenv("BAGNOLD_PYTHON")) pythons = {chosen};
  for (auto const& python : pythons)
    if (run_script(python, script, data.string(), target.string()) == 0) return "";
  return fmt::format("no picture drawn: {} with h5py and matplotlib is needed", pythons.front());
}

}  // namespace

std::string draw_plot(std::filesystem::path const& result, std::filesystem::path const& picture) {
  return draw(plot_script, result, picture);
}

std::string draw_frames(std::filesystem::path const& result, std::filesystem::path const& folder) {
  return draw(plot_frames_script, result, folder);
}

std::string draw_analysis(std::filesystem::path const& drawn, std::filesystem::path const& picture) {
  return draw(plot_analysis_script, drawn, picture);
}

}  // namespace bagnold
