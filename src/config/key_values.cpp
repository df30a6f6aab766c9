// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/key_values.hpp"

#include <fmt/format.h>

#include <type_traits>

#include "src/config/keys.hpp"
#include "src/config/scene_file.hpp"

namespace bagnold {

namespace {

std::string text_of(std::vector<double> const& list) {
  return fmt::format("[{}]", fmt::join(list, ", "));
}

std::string text_of(std::vector<SequencePiece> const& list) {
  std::vector<std::string> pieces;
  for (auto const& [rate, amount] : list) pieces.push_back(fmt::format("[{}, {}]", rate, amount));
  return fmt::format("[{}]", fmt::join(pieces, ", "));
}

}  // namespace

std::vector<KeyValue> key_values(std::string const& text, std::string const& origin,
                                 std::filesystem::path const& folder) {
  Scene const scene = parse_scene(text, origin, folder);
  std::vector<KeyValue> values;
  for_each_key(scene, [&](Key const& key, auto const& member) {
    using Member = std::decay_t<decltype(member)>;
    KeyValue value{std::string(key.name), {}, {}};
    if constexpr (std::is_arithmetic_v<Member>) value.number = static_cast<double>(member);
    if constexpr (std::is_same_v<Member, std::optional<double>>) value.number = member;
    if constexpr (std::is_same_v<Member, NumberOrWord>) value.number = member.number;
    if constexpr (std::is_same_v<Member, std::string>) value.text = member;
    if constexpr (requires { text_of(member); }) value.text = text_of(member);
    if constexpr (std::is_same_v<Member, NumberOrList>) {
      if (member.is_list())
        value.text = text_of(member.each);
      else
        value.number = member.at(0);
    }
    values.push_back(std::move(value));
  });
  return values;
}

}  // namespace bagnold
