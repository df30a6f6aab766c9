// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <vector>

#include "src/cli/exit_code.hpp"
#include "src/cli/options.hpp"
#include "src/config/errors.hpp"
#include "src/config/keys.hpp"
#include "src/config/scene_file.hpp"
#include "src/config/shell_word.hpp"
#include "src/io/atomic_file.hpp"

namespace bagnold {

namespace {

/// Keys that a first scene shows; all others have defaults.
constexpr std::string_view shown_keys[] = {"disks.model",
                                           "disks.count",
                                           "disks.packing_fraction",
                                           "disks.elasticity",
                                           "disks.mass",
                                           "disks.seed",
                                           "shear.protocol",
                                           "shear.strain_rate",
                                           "shear.strain_rates",
                                           "shear.strain",
                                           "shear.ramp_rate",
                                           "shear.strain_rate_high",
                                           "shear.cycles",
                                           "shear.ramp_window",
                                           "shear.ramp_every",
                                           "shear.pieces",
                                           "shear.amplitude",
                                           "shear.period",
                                           "shear.peak_rate",
                                           "shear.stress",
                                           "shear.time",
                                           "shear.pressure",
                                           "output.trajectory_strain",
                                           "output.trajectory_decades",
                                           "output.trajectory_time",
                                           "output.plot"};

/// A scene of this protocol that takes seconds to a minute.
Scene first_scene(std::string const& protocol) {
  Scene scene;
  scene.disks.model = "CD_n";
  scene.disks.count = 1024;
  scene.disks.packing_fraction = 0.8;
  scene.disks.elasticity = 5;
  scene.disks.mass = "area";
  scene.shear.protocol = protocol;
  scene.shear.strain_rate = 1e-4;
  scene.shear.strain = 10.0;
  if (scene.shear.run_per_rate()) scene.shear.strain_rates = {1e-2, 1e-3, 1e-4};
  if (scene.shear.ramps()) {  // about the transition of CD_rot, P2 Fig. 31
    scene.disks.model = "CD_rot";
    scene.disks.packing_fraction = 0.79;
    scene.disks.elasticity = 1;
    scene.disks.mass = "equal";
    scene.disks.count = 256;
    scene.shear.strain_rate = 2e-5;
    scene.shear.strain_rate_high = 1e-3;
    scene.shear.strain = 0.5;
    scene.shear.ramp_rate = 1e-4;
    scene.shear.ramp_window = 100;
    scene.shear.ramp_every = 5;
  }
  scene.shear.pressure = 1e-5;
  if (scene.shear.by_pieces()) {  // about jamming
    scene.disks.model = "CD";
    scene.disks.packing_fraction = 0.845;
    scene.disks.elasticity = 1;
    scene.disks.mass = "equal";
    scene.disks.count = 256;
    scene.shear.pieces = {{1e-3, 0.5}, {-1e-3, 0.5}, {0, 1e3}};
    scene.shear.amplitude = 0.05;
    scene.shear.period = 400;
    scene.shear.stress = NumberOrList(std::vector{1e-3, 3e-4});
    scene.shear.time = 2e4;
    scene.shear.cycles = scene.shear.oscillates() ? 6 : 1;
  }
  return scene;
}

std::string comment_of(Key const& key) {
  auto text = std::string(key.meaning);
  bool const told = !key.words.empty() && text.find(key.words.front()) != std::string::npos;
  if (!key.words.empty() && !told) text += fmt::format(": {}", fmt::join(key.words, ", "));
  if (!key.unit.empty()) text += fmt::format(" [{}]", key.unit);
  return text;
}

/// Text of the scene with the meaning of its keys.
std::string explained(Scene const& scene, std::string const& name) {
  std::map<std::string, std::string> comments;
  for_each_key(scene, [&](Key const& key, auto const&) {
    comments.emplace(std::string(key.name), comment_of(key));
  });
  auto text = fmt::format(
      "#:schema ./scene.schema.json\n# `bagnold validate {0}` checks this scene, `bagnold run {0}` "
      "runs it. `bagnold schema --out\n# scene.schema.json` tells an editor what keys there are; "
      "those that are not here have defaults.\ntitle = \"\"\n",
      shell_word(name));
  std::string table;
  for (auto const& [key, value] : written_keys(scene)) {
    if (std::ranges::count(shown_keys, key) == 0) continue;
    auto const dot = key.find('.');
    if (key.substr(0, dot) != table) {
      table = key.substr(0, dot);
      text += fmt::format("\n[{}]\n", table);
    }
    auto const line = fmt::format("{} = {}", key.substr(dot + 1), value);
    text += fmt::format("{:<30} # {}\n", line, comments.at(key));
  }
  return text;
}

}  // namespace

Command add_init(Words program) {
  struct Options {
    std::filesystem::path file = "scene.toml";
    std::string protocol = "steady";
  };
  auto const options = std::make_shared<Options>();
  Words command = add_command(program, "init", "write a first scene, with what its keys mean");
  command.option("FILE", options->file, "file to write [scene.toml]");
  command
      .option("--protocol", options->protocol,
              "steady, cascade, ramp, sequence, oscillate, stress or pressure [steady]")
      .one_of({"steady", "cascade", "ramp", "sequence", "oscillate", "stress", "pressure"});
  return {command, [options] {
            auto const name = options->file.string();
            if (std::filesystem::exists(options->file))
              throw InputError(fmt::format(
                  "{}: is there already, and would be lost; name another file, as `bagnold init "
                  "other.toml`",
                  name));
            io::replace_text(options->file, explained(first_scene(options->protocol), name));
            fmt::print("{}\n", name);
            return done;
          }};
}

}  // namespace bagnold
