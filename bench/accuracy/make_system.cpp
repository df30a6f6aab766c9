// SPDX-License-Identifier: BSD-3-Clause
#include "bench/accuracy/make_system.hpp"

namespace bagnold::accuracy {

std::span<std::string const> scheme_names() {
  static std::string const names[] = {
      "modified-velocity-verlet", "lagged-velocity-verlet", "groot-warren", "implicit-verlet",
      "pairwise-sweep",           "increment-sweep",        "two-stage"};
  return names;
}

std::unique_ptr<System> make_system(Scene const& scene, State const& state, Method const& method,
                                    bool synchronous) {
  auto const& model = scene.disks.model;
  if (model == CD::name) return make_for_law<CD>(scene, state, method, synchronous);
  if (model == CDn::name) return make_for_law<CDn>(scene, state, method, synchronous);
  if (model == CDrot::name) return make_for_law<CDrot>(scene, state, method, synchronous);
  throw InputError("model = \"" + model + "\" (must be CD, CD_n or CD_rot here)");
}

}  // namespace bagnold::accuracy
