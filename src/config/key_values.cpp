// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/key_values.hpp"

#include <type_traits>

#include "src/config/keys.hpp"
#include "src/config/scene_file.hpp"

namespace bagnold {

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
    values.push_back(std::move(value));
  });
  return values;
}

}  // namespace bagnold
