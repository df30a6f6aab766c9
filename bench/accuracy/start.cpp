// SPDX-License-Identifier: BSD-3-Clause
#include "bench/accuracy/start.hpp"

#include <fmt/format.h>

#include <sstream>

#include "src/io/state_file.hpp"
#include "src/start/start.hpp"

namespace bagnold::accuracy {

void Start::add_options(CLI::App& app) {
  scene.disks.model = "CD_n";
  scene.disks.mass = "equal";
  scene.disks.packing_fraction = 0.78;
  scene.disks.elasticity = 1;
  scene.shear.strain_rate = 1e-3;
  app.add_option("--state", state, "state file to start from")->required();
  app.add_option("--model", scene.disks.model, "CD, CD_n, CD_rot")->capture_default_str();
  app.add_option("--mass", scene.disks.mass, "equal, area")->capture_default_str();
  app.add_option("--phi", scene.disks.packing_fraction, "packing fraction")->capture_default_str();
  app.add_option("--q", scene.disks.elasticity, "elasticity Q")->capture_default_str();
  app.add_option("--rate", scene.shear.strain_rate, "strain rate")->capture_default_str();
  app.add_option("--skin", skin, "of the neighbour list")->capture_default_str();
}

State Start::read() {
  auto states = io::read_states(state);
  states.resize(1);
  scene.disks.count = static_cast<std::int64_t>(states[0].count());
  scene.integration.skin = skin;
  scene.start.file = state;
  return fit_to_scene(std::move(states), scene)[0].state;
}

Method read_method(std::string const& text) {
  std::stringstream parts(text);
  std::string scheme, step, precision;
  std::getline(parts, scheme, ':');
  std::getline(parts, step, ':');
  std::getline(parts, precision, ':');
  Method method;
  method.time_step = 0;
  std::stringstream words(scheme);
  std::getline(words, method.scheme, '+');
  for (std::string word; std::getline(words, word, '+');) {
    if (word == "packs")
      method.arrangement.packs = true;
    else if (word.starts_with("blocks="))
      method.arrangement.tiles = std::stoi(word.substr(7));
    else
      throw InputError("+" + word + " in " + text + " (not known); use +packs or +blocks=N");
  }
  std::stringstream(step) >> method.time_step;
  if (!(method.time_step > 0))
    throw InputError(text + " (needs a time step above 0); write it as " + scheme + ":0.1");
  if (!precision.empty()) method.precision = precision;
  return method;
}

std::string scene_columns(Scene const& scene) {
  auto const& d = scene.disks;
  return fmt::format("{},{},{},{},{}", d.model, d.mass, d.packing_fraction, d.elasticity,
                     scene.shear.strain_rate);
}

std::string method_columns(Method const& m) {
  auto const& a = m.arrangement;
  return fmt::format("{},{}{},{},{}", m.scheme, a.packs ? "packs" : "index",
                     a.tiles > 1 ? fmt::format(" {}x{}", a.tiles, a.tiles) : "", m.precision,
                     m.time_step);
}

}  // namespace bagnold::accuracy
