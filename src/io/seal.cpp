// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/seal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "src/io/atomic_file.hpp"
#include "src/io/hash.hpp"

namespace bagnold::io {
namespace {

constexpr std::string_view first_words = "\nbagnold-seal ";

std::string seal_of(std::size_t size, std::string const& hash) {
  return fmt::format("{}{:>20} xxh3 {:>23}\n", first_words, size, hash);
}

}  // namespace

std::string seal_of(std::span<std::byte const> content) {
  return seal_of(content.size(), xxh3_hex(content));
}

void add_seal(std::vector<std::byte>& content) {
  auto const seal = seal_of(content);
  auto const bytes = std::as_bytes(std::span(seal));
  content.insert(content.end(), bytes.begin(), bytes.end());
}

void replace_sealed(std::filesystem::path const& path, std::span<std::byte const> content) {
  auto const seal = seal_of(content);
  replace_file(path, content, std::as_bytes(std::span(seal)));
}

bool has_seal(std::span<std::byte const> content) {
  return content.size() >= seal_bytes &&
         std::ranges::equal(std::as_bytes(std::span(first_words)),
                            content.last(seal_bytes).first(first_words.size()));
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

bool is_sealed(std::filesystem::path const& path) {
  if (!std::filesystem::exists(path)) return false;
  Xxh3 hash;
  std::size_t size = 0;
  std::string last;  // the last bytes seen: a seal, if there is one
  for_each_block(path, [&](std::span<std::byte const> block) {
    last.append(reinterpret_cast<char const*>(block.data()), block.size());
    if (last.size() <= seal_bytes) return true;
    auto const body = last.size() - seal_bytes;
    hash.add(std::as_bytes(std::span(last).first(body)));
    size += body;
    last.erase(0, body);
    return true;
  });
  return last.size() == seal_bytes && last == seal_of(size, hash.hex());
}

}  // namespace bagnold::io
