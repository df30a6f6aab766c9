// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/run_apart.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <span>
#include <system_error>

#include "src/config/errors.hpp"
#include "src/io/descriptor.hpp"

namespace bagnold::io {
namespace {

[[noreturn]] void fail(char const* what) {
  throw FileError(fmt::format("cannot {} ({}); end other programs", what,
                              std::generic_category().message(errno)));
}

bool write_all(int pipe, std::span<std::byte const> bytes) {
  while (!bytes.empty()) {
    auto const written = ::write(pipe, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return true;
}

/// Work of the child. Its death is expected: it leaves no core, and no words of libc.
[[noreturn]] void work_and_exit(std::function<std::vector<std::byte>()> const& work, int pipe) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // it has the run's lock open
  struct rlimit const none{};
  ::setrlimit(RLIMIT_CORE, &none);
  int const nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  ::dup2(nowhere, STDERR_FILENO);
  try {
    ::_exit(write_all(pipe, work()) ? 0 : 1);
  } catch (...) {
    ::_exit(1);
  }
}

std::vector<std::byte> read_all(int pipe) {
  std::vector<std::byte> all;
  std::vector<std::byte> block(std::size_t{1} << 16);
  while (true) {
    auto const got = ::read(pipe, block.data(), block.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return all;
    all.insert(all.end(), block.begin(), block.begin() + got);
  }
}

}  // namespace

std::optional<std::vector<std::byte>> run_apart(
    std::function<std::vector<std::byte>()> const& work) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) fail("make a pipe");
  Descriptor const near_end(ends[0]);
  Descriptor far_end(ends[1]);
  auto const child = ::fork();
  if (child < 0) fail("start a process");
  if (child == 0) work_and_exit(work, far_end.get());
  far_end = Descriptor();
  auto answer = read_all(near_end.get());
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) return std::nullopt;
  return answer;
}

}  // namespace bagnold::io
