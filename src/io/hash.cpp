// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/hash.hpp"

#include <fmt/format.h>
#include <xxhash.h>

namespace bagnold::io {

std::uint64_t xxh3(std::span<std::byte const> bytes) {
  return XXH3_64bits(bytes.data(), bytes.size());
}

std::string xxh3_hex(std::span<std::byte const> bytes) {
  return fmt::format("{:016x}", xxh3(bytes));
}

}  // namespace bagnold::io
