// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "src/config/ladder.hpp"
#include "src/config/scene.hpp"

namespace bagnold::bias {

/// Strain between the instants at which pairs may begin.
inline constexpr double grid_strain = 0.3;

/// The method of a run and a finer one, and the lengths of their stretches.
struct Methods {
  Scene coarse;        ///< as the run steps, by steps of all disks
  Scene fine;          ///< see methods_of()
  std::int64_t ratio;  ///< steps of `fine` in a step of `coarse`
  std::int64_t third;  ///< of a stretch, [steps of coarse]
  std::int64_t grid;   ///< between instants at which pairs may begin, [steps of coarse]

  std::int64_t length() const { return 3 * third; }  ///< of a stretch, [steps of coarse]
  double strain() const;                             ///< of a stretch
};

/// Methods of a run whose scheme and step are named.
Methods methods_of(Scene const& scene);

/// A method of the ladder of a scene, and a finer one: beside quasi-static steps implicit damping
/// at its rule, beside implicit damping two stages at theirs, or at a quarter of it where less than
/// usual_accuracy is asked for. Stretches are as long as the grid of a ladder that shares.
Methods methods_of(Scene const& scene, Ladder const& ladder, Method const& method);

/// Scheme and step of a scene: "implicit-damping, a step of 1.6 tau_e".
std::string method_in_words(Scene const& scene);

}  // namespace bagnold::bias
