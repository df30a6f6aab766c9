// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/descriptor.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <cerrno>
#include <system_error>

#include "src/config/errors.hpp"
#include "src/config/shell_word.hpp"

namespace bagnold::io {
namespace {

/// Folder of the run that a file belongs to; parts of a trajectory lie in a folder within it.
std::filesystem::path folder_of(std::filesystem::path const& path) {
  auto const folder = path.parent_path();
  auto const of_run = folder.extension() == ".parts" ? folder.parent_path() : folder;
  return of_run.empty() ? std::filesystem::path(".") : of_run;
}

std::string remedy(std::filesystem::path const& path, int error) {
  auto const folder = folder_of(path);
  bool const is_first =
      path.filename().string().starts_with("scene.toml");  // nothing to resume yet
  auto const again = is_first
                         ? std::string("then give the same command again")
                         : fmt::format("then `bagnold resume {}`", shell_word(folder.string()));
  switch (error) {
    case ENOSPC:
      return "free some space, " + again;
    case EDQUOT:
      return "free some of your quota, " + again;
    case EFBIG:
      return "raise the limit on file sizes (ulimit -f), " + again;
    case EIO:
      return "the disk or the network reports a fault: check it, " + again;
    case EACCES:
    case EPERM:
      return fmt::format("check the permissions of {}, or use another folder", folder.string());
    case EROFS:
      return "the file system is read-only: use another folder";
    case ENOENT:
    case ENOTDIR:
      return "check the path";
    case EMFILE:
    case ENFILE:
      return "raise the limit on open files (ulimit -n)";
    default:
      return "check the file and its folder";
  }
}

}  // namespace

Descriptor open_descriptor(std::filesystem::path const& path, int flags) {
  int number = -1;
  do {
    number = ::open(path.c_str(), flags | O_CLOEXEC, 0666);
  } while (number < 0 && errno == EINTR);
  return Descriptor(number);
}

void fail_on(std::string_view action, std::filesystem::path const& path, int error) {
  throw FileError(fmt::format("cannot {} {}: {}: {}", action, path.string(),
                              std::generic_category().message(error), remedy(path, error)));
}

}  // namespace bagnold::io
