// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/hash.hpp"

#include <fmt/format.h>
#include <xxhash.h>

namespace bagnold::io {

std::uint64_t xxh3(std::span<std::byte const> bytes) {
  return XXH3_64bits(bytes.data(), bytes.size());
}

Xxh3::Xxh3()
    : state_(XXH3_createState(), [](void* s) { XXH3_freeState(static_cast<XXH3_state_t*>(s)); }) {
  XXH3_64bits_reset(static_cast<XXH3_state_t*>(state_.get()));
}

void Xxh3::add(std::span<std::byte const> bytes) {
  XXH3_64bits_update(static_cast<XXH3_state_t*>(state_.get()), bytes.data(), bytes.size());
}

std::string Xxh3::hex() const {
  return fmt::format("{:016x}", XXH3_64bits_digest(static_cast<XXH3_state_t const*>(state_.get())));
}

std::string xxh3_hex(std::span<std::byte const> bytes) {
  return fmt::format("{:016x}", xxh3(bytes));
}

}  // namespace bagnold::io
