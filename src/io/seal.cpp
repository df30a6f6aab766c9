// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/seal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "src/io/hash.hpp"

namespace bagnold::io {
namespace {

constexpr std::size_t seal_bytes = 64;

std::string seal_of(std::span<std::byte const> content) {
  return fmt::format("\nbagnold-seal {:>20} xxh3 {:>23}\n", content.size(), xxh3_hex(content));
}

}  // namespace

void add_seal(std::vector<std::byte>& content) {
  auto const seal = seal_of(content);
  auto const bytes = std::as_bytes(std::span(seal));
  content.insert(content.end(), bytes.begin(), bytes.end());
}

std::string remove_seal(std::vector<std::byte>& content) {
  if (content.size() < seal_bytes) return "is too short to be whole";
  auto const body = content.size() - seal_bytes;
  auto const expected = seal_of(std::span(content).first(body));
  if (!std::ranges::equal(std::as_bytes(std::span(expected)), std::span(content).subspan(body)))
    return "does not have the content that its seal tells: it was cut short or changed";
  content.resize(body);
  return "";
}

}  // namespace bagnold::io
