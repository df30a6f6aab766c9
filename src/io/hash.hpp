// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace bagnold::io {

/// xxh3, 64 bits, of the bytes.
std::uint64_t xxh3(std::span<std::byte const> bytes);

/// XXH3 hash as 16 hexadecimal digits, as files hold it.
std::string xxh3_hex(std::span<std::byte const> bytes);

/// The xxh3 of bytes that come piece by piece.
class Xxh3 {
 public:
  Xxh3();
  void add(std::span<std::byte const> bytes);
  std::string hex() const;

 private:
  std::shared_ptr<void> state_;
};

}  // namespace bagnold::io
