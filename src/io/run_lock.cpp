// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/run_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <climits>
#include <string>

#include "src/config/errors.hpp"

namespace bagnold::io {
namespace {

/// What the holder wrote, fit for a terminal.
std::string holder(Descriptor const& file) {
  std::array<char, 256> text{};
  auto const got = ::pread(file.get(), text.data(), text.size(), 0);
  std::string line;
  for (ssize_t index = 0; index < got; ++index) {
    auto const letter = text[static_cast<std::size_t>(index)];
    if (letter == '\n') break;
    line += letter >= ' ' && letter <= '~' ? letter : '?';
  }
  return line.empty() ? "another process" : line;
}

std::string myself() {
  std::array<char, HOST_NAME_MAX + 1> host{};
  if (::gethostname(host.data(), host.size() - 1) != 0) host = {"unknown"};
  return fmt::format("host {}, pid {}\n", host.data(), ::getpid());
}

}  // namespace

RunLock::RunLock(std::filesystem::path const& folder) {
  auto const path = folder / ".lock";
  file_ = open_descriptor(path, O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK);
  if (!file_.open()) fail_on("make the lock", path, errno);
  while (::flock(file_.get(), LOCK_EX | LOCK_NB) != 0) {
    if (errno == EINTR) continue;
    if (errno != EWOULDBLOCK) fail_on("lock", path, errno);
    throw InputError(fmt::format("{} is in use by {}: wait for it, end it, or use another folder",
                                 folder.string(), holder(file_)));
  }
  auto const text = myself();
  if (::ftruncate(file_.get(), 0) != 0 ||
      ::pwrite(file_.get(), text.data(), text.size(), 0) != static_cast<ssize_t>(text.size())) {
    // a full disk does not stop a resume: the lock itself is held, only its text is missing
  }
}

}  // namespace bagnold::io
