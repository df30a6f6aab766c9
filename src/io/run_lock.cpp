// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/run_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <climits>
#include <cstdlib>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>

#include "src/config/errors.hpp"

namespace bagnold::io {
namespace {

/// lock_holder() has a share of the lock for microseconds: who meets that waits, rather than
/// refuse the folder because somebody looks at it.
constexpr std::chrono::milliseconds a_look{500};

/// Text that the holder wrote, fit for a terminal.
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

bool locks_wanted() {
  char const* const word = std::getenv("BAGNOLD_LOCKS");
  if (word == nullptr || std::string_view(word) == "on") return true;
  if (std::string_view(word) == "off") return false;
  throw InputError(
      fmt::format("BAGNOLD_LOCKS = {} in the environment (must be \"on\" or \"off\")", word));
}

/// Errors of file systems and kernels for a call that they do not have. 515 and 524 are of the
/// kernel's own, which no header names (linux/errno.h: ENOIOCTLCMD, ENOTSUPP), and which DVS and
/// some Lustre let through.
bool has_no_locks(int error) {
  constexpr std::array not_supported{
      ENOLCK,          ENOSYS,       EOPNOTSUPP,   EINVAL, ENOTTY, EPROTONOSUPPORT,
      ESOCKTNOSUPPORT, EPFNOSUPPORT, EAFNOSUPPORT, 515,    524};
  return std::find(not_supported.begin(), not_supported.end(), error) != not_supported.end();
}

std::string text_of(int error) {
  return error >= 512 ? fmt::format("not supported, errno {}", error)
                      : std::generic_category().message(error);
}

}  // namespace

RunLock::RunLock(std::filesystem::path const& folder)
    : path_(folder), folder_(open_descriptor(folder, O_PATH | O_DIRECTORY)) {
  if (!folder_.open()) fail_on("open the folder", folder, errno);
  if (!locks_wanted()) return;
  auto const path = folder / ".lock";
  file_ = open_descriptor(path, O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK);
  if (!file_.open()) fail_on("make the lock", path, errno);
  take();
  sign();
}

void RunLock::take() {
  auto const patience = std::chrono::steady_clock::now() + a_look;
  while (::flock(file_.get(), LOCK_EX | LOCK_NB) != 0) {
    if (errno == EINTR) continue;
    if (errno == EWOULDBLOCK && std::chrono::steady_clock::now() < patience) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      continue;
    }
    if (errno == EWOULDBLOCK)
      throw InputError(fmt::format("{} is in use by {}: wait for it, end it, or use another folder",
                                   path_.string(), holder(file_)));
    if (!has_no_locks(errno)) fail_on("lock", path_ / ".lock", errno);
    remark_ = fmt::format(
        "{} lies on a file system without locks ({}): nothing keeps a second process from writing "
        "there; see that there is none (BAGNOLD_LOCKS=off in the environment says that you do)",
        path_.string(), text_of(errno));
    return;
  }
}

void RunLock::sign() const {
  auto const text = myself();
  if (::ftruncate(file_.get(), 0) != 0 ||
      ::pwrite(file_.get(), text.data(), text.size(), 0) != static_cast<ssize_t>(text.size())) {
    // a full disk does not stop a resume: the lock itself is held, only its text is missing
  }
}

void RunLock::check_folder() const {
  struct stat held {
  }, there{};
  if (::fstat(folder_.get(), &held) != 0) fail_on("look at", path_, errno);
  int const found = ::stat(path_.c_str(), &there);
  if (found != 0 && errno != ENOENT && errno != ENOTDIR) fail_on("look at", path_, errno);
  if (found == 0 && held.st_dev == there.st_dev && held.st_ino == there.st_ino) return;
  throw FileError(
      fmt::format("{} is no longer the folder of this run: it was moved or removed; `bagnold "
                  "resume` it where it is",
                  path_.string()));
}

std::string lock_holder(std::filesystem::path const& folder) {
  auto const file = open_descriptor(folder / ".lock", O_RDONLY | O_NOFOLLOW | O_NONBLOCK);
  if (!file.open()) return {};
  // shared, and let go of when the descriptor is closed, at once
  if (::flock(file.get(), LOCK_SH | LOCK_NB) == 0 || errno != EWOULDBLOCK) return {};
  return holder(file);
}

}  // namespace bagnold::io
