// SPDX-License-Identifier: BSD-3-Clause
#include "src/sweep/child.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <utility>

#include "src/run/cores.hpp"
#include "src/sweep/report.hpp"

namespace bagnold::sweep {

namespace {

/// Holds back signals that ask to stop. One that comes between fork() and exec() would be caught by
/// the handler of this program, whose flag exec() discards.
class HeldSignals {
 public:
  HeldSignals() {
    sigset_t stops;
    sigemptyset(&stops);
    for (int const signal : asking_to_stop) sigaddset(&stops, signal);
    ::pthread_sigmask(SIG_BLOCK, &stops, &before_);
  }
  ~HeldSignals() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

  /// Releases the signals in the new process, as exec() will find them: ignored ones stay ignored.
  void let_go_in_child() const {
    for (int const signal : asking_to_stop) {
      struct sigaction action {};
      if (::sigaction(signal, nullptr, &action) == 0 && action.sa_handler != SIG_IGN)
        ::signal(signal, SIG_DFL);
    }
    ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }

 private:
  static constexpr int asking_to_stop[] = {SIGINT, SIGTERM, SIGHUP};
  sigset_t before_{};
};

/// Runs the new process; never returns.
[[noreturn]] void become(std::vector<char*> const& arguments, int log, int reports, pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(126);  // it ended before the prctl() above
  int const nothing = ::open("/dev/null", O_RDONLY);
  ::dup2(nothing, STDIN_FILENO);
  ::dup2(log, STDOUT_FILENO);
  ::dup2(log, STDERR_FILENO);
  ::fcntl(reports, F_SETFD, 0);  // survives exec
  unbind_new_program();
  ::setenv(report_variable, fmt::format("{}", reports).c_str(), 1);
  ::execvp(arguments.front(), arguments.data());
  ::_exit(127);
}

}  // namespace

Child::Child(std::vector<std::string> const& command, std::filesystem::path const& log) {
  auto const log_file = io::open_descriptor(
      log, O_WRONLY | O_CREAT | O_APPEND | O_NOFOLLOW | O_NONBLOCK);  // no wait for a pipe's reader
  if (!log_file.open()) io::fail_on("write", log, errno);
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC | O_NONBLOCK) != 0) io::fail_on("make a pipe for", log, errno);
  reports_ = io::Descriptor(ends[0]);
  io::Descriptor const far_end(ends[1]);
  std::vector<char*> arguments;
  for (auto const& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  pid_t const parent = ::getpid();
  HeldSignals const held;
  pid_ = ::fork();
  if (pid_ < 0) io::fail_on("start a process for", log, errno);
  if (pid_ > 0) return;
  held.let_go_in_child();
  become(arguments, log_file.get(), far_end.get(), parent);
}

Child::Child(Child&& other) noexcept
    : pid_(std::exchange(other.pid_, -1)), reports_(std::move(other.reports_)) {}

Child& Child::operator=(Child&& other) noexcept {
  std::swap(pid_, other.pid_);
  std::swap(reports_, other.reports_);
  return *this;
}

Child::~Child() {
  if (pid_ < 0) return;
  ::kill(pid_, SIGKILL);
  while (::waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

std::optional<double> Child::share() {
  std::optional<double> last;
  double told = 0;
  while (::read(reports_.get(), &told, sizeof told) == sizeof told) last = told;
  return last;
}

std::optional<int> Child::exit_code() {
  int status = 0;
  if (::waitpid(pid_, &status, WNOHANG) != pid_) return std::nullopt;
  pid_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

void Child::ask_to_stop() const { ::kill(pid_, SIGTERM); }

}  // namespace bagnold::sweep
