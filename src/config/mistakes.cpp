// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/mistakes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

namespace bagnold {

void Mistakes::add(std::string const& key, std::string const& message) {
  keys_.push_back(key);
  messages_.push_back(message);
}

bool Mistakes::about(std::string_view key) const {
  return std::ranges::any_of(keys_, [&](std::string const& wrong) {
    return !wrong.empty() && (key == wrong || key.starts_with(wrong + "."));
  });
}

void Mistakes::throw_any() const {
  constexpr std::size_t most = 20;
  if (messages_.empty()) return;
  auto const told = std::span(messages_).first(std::min(most, messages_.size()));
  auto text = fmt::format("{}", fmt::join(told, "\n"));
  if (messages_.size() > most) text += fmt::format("\nand {} more", messages_.size() - most);
  throw InputError(text);
}

}  // namespace bagnold
