// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/plot.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <utility>
#include <vector>

#include "figure_data_script.hpp"
#include "plot_analysis_script.hpp"
#include "plot_figure_script.hpp"
#include "plot_frames_script.hpp"
#include "plot_script.hpp"
#include "plotting_script.hpp"
#include "src/run/pythons.hpp"

namespace bagnold {

namespace fs = std::filesystem;

namespace {

/// A script of scripts/ and those that it imports, which Python could not find: the program is one
/// file.
struct Script {
  char const* text;
  std::vector<std::pair<char const*, char const*>> imported;  ///< name, text
};

/// One text: imported ones become modules first.
std::string whole(Script const& script) {
  std::string text = "import sys, types\n";
  for (auto const& [name, body] : script.imported)
    text += fmt::format(
        "module = types.ModuleType('{0}')\nexec(r'''{1}''', module.__dict__)\n"
        "sys.modules['{0}'] = module\n",
        name, body);
  return text + script.text;
}

/// Runs `python -I - data target` with the text on its standard input, its output thrown away, its
/// errors too if `quiet`. Returns its exit code; 127 if it cannot be started. -I, and a folder that
/// only the system's owner writes to, so that neither Python nor matplotlib takes code or settings
/// from where the user stands.
int run_script(fs::path const& python, std::string const& text, fs::path const& data,
               fs::path const& target, bool quiet) {
  int ends[2];  // a socket: what Python does not read before it ends sends no SIGPIPE
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) return 127;
  pid_t const child = fork();
  if (child < 0) return 127;
  if (child == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);  // no picture of a folder that another process may take over
    int const nowhere = open("/dev/null", O_WRONLY);
    dup2(ends[0], STDIN_FILENO);
    dup2(nowhere, STDOUT_FILENO);
    if (quiet) dup2(nowhere, STDERR_FILENO);
    if (chdir("/") == 0)
      execl(python.c_str(), python.c_str(), "-I", "-", data.c_str(), target.c_str(),
            static_cast<char*>(nullptr));
    _exit(127);
  }
  close(ends[0]);
  for (std::size_t sent = 0; sent < text.size();) {
    ssize_t const now = send(ends[1], text.data() + sent, text.size() - sent, MSG_NOSIGNAL);
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
std::string draw(Script const& script, fs::path const& data, fs::path const& target,
                 bool quiet = true) {
  auto const text = whole(script);
  for (auto const& python : pythons()) {
    int const code = run_script(python, text, fs::absolute(data), fs::absolute(target), quiet);
    if (code == 0) return "";
    if (!quiet && code != 127) return "no picture drawn, see above";
  }
  return "no picture drawn: python3 with h5py and matplotlib is needed (BAGNOLD_PYTHON may name "
         "one, by its absolute path; PYTHONPATH and packages of a user alone are not looked at)";
}

std::pair<char const*, char const*> const plotting{"plotting", plotting_script};
std::pair<char const*, char const*> const analysis{"plot_analysis", plot_analysis_script};
std::pair<char const*, char const*> const figure_data{"figure_data", figure_data_script};

}  // namespace

std::string draw_plot(std::filesystem::path const& result, std::filesystem::path const& picture) {
  return draw({plot_script, {plotting}}, result, picture);
}

std::string draw_frames(std::filesystem::path const& result, std::filesystem::path const& folder) {
  return draw({plot_frames_script, {plotting}}, result, folder);
}

std::string draw_analysis(std::filesystem::path const& drawn,
                          std::filesystem::path const& picture) {
  return draw({plot_analysis_script, {plotting}}, drawn, picture);
}

std::string draw_figure(std::filesystem::path const& recipe, std::filesystem::path const& picture) {
  return draw({plot_figure_script, {plotting, analysis, figure_data}}, recipe, picture, false);
}

}  // namespace bagnold
