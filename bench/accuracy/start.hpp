// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "bench/accuracy/system.hpp"
#include "src/config/skin.hpp"

namespace bagnold::accuracy {

/// What is sheared, and from where.
struct Start {
  std::string state;  ///< a state file of one system or several, of which the first is taken
  Scene scene;
  double skin = usual_skin;  ///< [d_s]

  void add_options(CLI::App& app);
  State read();  ///< fits it to the scene, whose N it sets
};

/// "two-stage:0.2" or "two-stage:0.2:float-pairs", with "+packs" and "+blocks=4" behind the scheme.
Method read_method(std::string const& text);

/// model,mass,phi,Q,rate - and scheme,arrangement,precision,dt
std::string scene_columns(Scene const& scene);
std::string method_columns(Method const& method);
inline constexpr char scene_header[] = "model,mass,phi,Q,rate";
inline constexpr char method_header[] = "scheme,arrangement,precision,dt";

}  // namespace bagnold::accuracy
