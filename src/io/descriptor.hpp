// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <unistd.h>

#include <filesystem>
#include <string_view>
#include <utility>

namespace bagnold::io {

/// An open file of the operating system, closed when it goes out of scope.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }

  bool open() const { return number_ >= 0; }
  int get() const { return number_; }
  int release() { return std::exchange(number_, -1); }

 private:
  int number_;
};

/// open(2) that goes on after a signal; the descriptor does not survive exec.
Descriptor open_descriptor(std::filesystem::path const& path, int flags);

/// Throws FileError: what was tried on which path, why the system refused (an errno), what to do.
[[noreturn]] void fail_on(std::string_view action, std::filesystem::path const& path, int error);

}  // namespace bagnold::io
