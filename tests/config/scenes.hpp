// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "src/config/errors.hpp"
#include "src/config/keys.hpp"
#include "src/config/scene_file.hpp"
#include "src/config/schemes.hpp"

/// What the tests of scenes start from.
namespace bagnold {

inline std::string const disks_text = R"([disks]
model = "CD_rot"
count = 1024
packing_fraction = 0.82
elasticity = 1.0
mass = "equal"
)";

/// The required keys and nothing else, one a line: model is line 2, strain line 9.
inline std::string const minimal_text = disks_text + R"([shear]
strain_rate = 1e-4
strain = 20.0
)";

/// The same for the other protocols.
inline std::string const cascade_text = disks_text + R"([shear]
protocol = "cascade"
strain_rates = [1e-3, 1e-4, 1e-5]
strain = [10, 20, 5.5]
)";
inline std::string const ramp_text = disks_text + R"([shear]
protocol = "ramp"
strain_rate = 1e-4
strain_rate_high = 1e-2
ramp_rate = 1e-4
)";

inline std::string const sequence_text = disks_text + R"([shear]
protocol = "sequence"
pieces = [[1e-4, 2.0], [-1e-4, 2.0], [0, 1e4]]
)";
inline std::string const oscillation_text = disks_text + R"([shear]
protocol = "oscillate"
amplitude = 0.01
period = 1e5
cycles = 2
)";

inline std::string const stress_text = disks_text + R"([shear]
protocol = "stress"
strain_rate = 1e-4
stress = 1e-3
time = 1e5
)";
inline std::string const pressure_text = disks_text + R"([shear]
protocol = "pressure"
strain_rate = 1e-4
pressure = 1e-3
strain = 10.0
)";

/// One of these that may have this key.
inline std::string const& text_for(Key const& key) {
  if (belongs(key, "steady")) return minimal_text;
  if (belongs(key, "ramp")) return ramp_text;
  if (belongs(key, "cascade")) return cascade_text;
  if (belongs(key, "sequence")) return sequence_text;
  if (belongs(key, "oscillate")) return oscillation_text;
  return belongs(key, "stress") ? stress_text : pressure_text;
}

inline Scene parse(std::string const& text, std::vector<std::string> const& overrides = {}) {
  return parse_scene(text, "scene.toml", "/folder", overrides);
}

/// The required keys, and two stages: a run of its strain would choose a scheme by itself.
inline Scene minimal_scene() {
  Scene scene = parse(minimal_text);
  scene.integration.scheme = default_scheme;
  return scene;
}

/// The message with which a text is refused as bad input; "accepted" if it is not.
inline std::string refusal(std::string const& text,
                           std::vector<std::string> const& overrides = {}) {
  try {
    parse(text, overrides);
  } catch (InputError const& error) {
    return error.what();
  }
  return "accepted";
}

inline bool has(std::string const& message, std::string const& part) {
  return message.find(part) != std::string::npos;
}

/// `text` with the one line that sets `key` replaced by `line`.
inline std::string with_line(std::string text, std::string const& key, std::string const& line) {
  auto const begin = text.find("\n" + key + " = ") + 1;
  return text.replace(begin, text.find('\n', begin) - begin, line);
}

/// Whether all members agree, bit for bit.
inline bool same(Scene const& a, Scene const& b) {
  bool equal = true;
  for_each_key(a, [&](Key const& key, auto const& one) {
    for_each_key(b, [&](Key const& other, auto const& two) {
      if constexpr (std::is_same_v<decltype(one), decltype(two)>)
        if (key.name == other.name) equal = equal && one == two;
    });
  });
  return equal;
}

/// The root of the sources, which has inputs/.
inline std::filesystem::path const source_folder = BAGNOLD_SOURCE_FOLDER;

inline Scene::Disks disks(std::string const& model, double elasticity,
                          std::string const& mass = "equal") {
  Scene::Disks d;
  d.model = model;
  d.elasticity = elasticity;
  d.mass = mass;
  return d;
}

}  // namespace bagnold
