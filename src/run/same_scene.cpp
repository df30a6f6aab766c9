// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/same_scene.hpp"

#include <fmt/format.h>

#include <map>
#include <string>
#include <vector>

#include "src/config/errors.hpp"
#include "src/config/scene_file.hpp"
#include "src/config/shell_word.hpp"
#include "src/run/make_longer.hpp"

namespace bagnold {

namespace {

std::map<std::string, std::string> values_of(Scene const& scene) {
  auto const keys = written_keys(scene);
  return {keys.begin(), keys.end()};
}

/// "disks.seed = 2, there it is 1; ..." of the keys that differ, three at most.
std::string differences(Scene const& wanted, Scene const& there) {
  auto const ours = values_of(wanted);
  auto theirs = values_of(there);
  std::vector<std::string> found;
  for (auto const& [key, value] : ours) {
    auto const other = theirs.find(key);
    if (other == theirs.end())
      found.push_back(fmt::format("{} = {}, not there", key, value));
    else if (other->second != value)
      found.push_back(fmt::format("{} = {}, there {}", key, value, other->second));
    if (other != theirs.end()) theirs.erase(other);
  }
  for (auto const& [key, value] : theirs)
    found.push_back(fmt::format("{} = {} there alone", key, value));
  constexpr std::size_t shown = 3;
  auto const more = found.size() > shown ? found.size() - shown : 0;
  found.resize(found.size() - more);
  return fmt::format("{}{}", fmt::join(found, "; "), more ? fmt::format("; {} more", more) : "");
}

}  // namespace

void refuse_other_scene(std::filesystem::path const& folder, Scene const& wanted) {
  auto const name = folder.string();
  auto const file = folder / "scene.toml";
  auto const refuse = [&](std::string const& why, std::string const& remedy) {
    throw InputError(fmt::format("--out {}: {}; {}another --out keeps it, --force replaces it",
                                 name, why, remedy));
  };
  if (!std::filesystem::exists(file))
    refuse("holds a run without its scene.toml, so that nothing tells whether it is of this scene",
           fmt::format("`bagnold resume {}` goes on with it, ", shell_word(name)));
  Scene there;
  try {
    there = read_kept_scene(file);
  } catch (InputError const& error) {
    refuse(fmt::format("holds a run whose scene cannot be read ({})", error.what()), "");
  }
  if (write_scene(there) == write_scene(wanted)) return;
  refuse(fmt::format("holds a run of another scene ({})", differences(wanted, there)),
         is_longer(there, wanted)
             ? fmt::format("`bagnold resume {} --strain {}` makes it as long, ", shell_word(name),
                           wanted.shear.strain.at(0))
             : "");
}

}  // namespace bagnold
