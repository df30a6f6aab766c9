// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace bagnold::io {

/// A folder of its own for one test, removed at its end.
class TestFolder {
 public:
  TestFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "bagnold-io-XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  ~TestFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TestFolder(TestFolder const&) = delete;
  TestFolder& operator=(TestFolder const&) = delete;

  std::filesystem::path operator/(std::string_view name) const { return path_ / name; }
  std::filesystem::path const& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

inline std::vector<std::byte> bytes_of(std::span<std::byte const> bytes) {
  return {bytes.begin(), bytes.end()};
}
inline std::vector<std::byte> bytes_of(std::string_view text) {
  auto const raw = std::as_bytes(std::span(text));
  return {raw.begin(), raw.end()};
}

/// Runs the function in a child of its own and returns its exit code; 128 + the signal if killed.
template <class Function>
int in_child(Function function) {
  auto const child = ::fork();
  if (child == 0) ::_exit(function());
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// The system's python, which has Debian's h5py; 0 if the program ran well.
inline int run_python(std::string const& program) {
  return std::system(("/usr/bin/python3 -c '" + program + "'").c_str());
}
inline bool have_h5py() { return run_python("import h5py, numpy") == 0; }

}  // namespace bagnold::io
