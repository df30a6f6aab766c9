// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

/// scheme = "auto": methods that a run tries in the order of their cost, and takes where their
/// bias, as measured in the run, is within integration.accuracy.
namespace bagnold {

struct Scene;

/// Strain of a stretch of a pair, of as many steps at least.
inline constexpr double stretch_strain = 0.03;
inline constexpr std::int64_t fewest_stretch_steps = 12;

/// Stretches at rates below 1e-5 where damping may decide: a time [tau_e], within which overlaps
/// settle, half of the mean gap between disks, (phi_J/phi)^(1/2) - 1, over which their neighbours
/// change, and a strain at least. Short stretches part less: less strain of them says as much.
inline constexpr double stretch_time = 3000, least_stretch_strain = 0.0075;

/// A scheme and the length of its step, in steps of the run: those of two stages at their rule.
struct Method {
  std::string_view scheme;
  std::int64_t length = 1;  ///< of a step
  std::int64_t parts = 1;   ///< of a step of the run, where it is divided

  bool operator==(Method const&) const = default;
};

/// Methods of a scene, the cheapest first.
struct Ladder {
  std::vector<Method> methods;
  std::size_t usual = 0;    ///< place of two stages at their rule, with which a run begins
  std::int64_t whole = 1;   ///< steps that hold whole ones of every method
  std::int64_t window = 1;  ///< steps of a measurement window
  std::int64_t grid = 1;    ///< steps between places at which the method may change, whole windows
  double stretch = stretch_strain;  ///< strain of a stretch of a pair, at least
  bool shares = false;      ///< the run may be a side of a pair; the grid is 3, 6, ... windows
  bool judges_all = false;  ///< the usual method is judged too, and finer ones follow it

  bool has_choice() const { return methods.size() > 1; }
};

/// Bias that two stages at their rule were nowhere seen to exceed (docs/accuracy.md). They are
/// judged where less is asked for.
inline constexpr double usual_accuracy = 0.01;

/// p_kin/p from which on a run no longer steps by a method that damps all: inertia has a part.
inline constexpr double most_kinetic = 3e-4;

/// p_kin/p from which on methods that damp all are not tried: 1e-4 max{1, Q}, up to most_kinetic. Q
/// is over the normal damping constant in units of 1/Q. At Q = 1 implicit damping moves soft
/// motions as if they had 2.5 times their mass, at larger Q nearly their own. The bias of that
/// builds up too slowly for pairs to see: p is 0.9% high in CD at 1.7e-4.
double least_inertia(Scene const& scene);

/// True for schemes with long steps, which are for flows that damping decides.
bool damps_all(std::string_view scheme);

/// Ladder of a scene; of one method where nothing is to be chosen.
Ladder ladder_of(Scene const& scene);

/// True if scheme = "auto" may change the method in a run of this scene.
bool may_change_method(Scene const& scene);

/// True if a scene that names no scheme is run by scheme = "auto": no time step is named either,
/// and the run is long enough to gain by it, or an accuracy below usual_accuracy is asked for.
bool auto_is_default(Scene const& scene);

/// Scene in which a method is named.
Scene with_method(Scene scene, Method const& method);

}  // namespace bagnold
