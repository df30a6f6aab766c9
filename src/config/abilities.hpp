// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "src/config/refusal.hpp"
#include "src/config/scene.hpp"

namespace bagnold {

/// Reason why an engine cannot run what a scene asks for, as messages put it behind the engine's
/// name; "{}" stands for the value in the scene. Empty: the engine can.
using WhyNot = std::string_view;

/// Abilities of an engine (integration.engine).
struct Abilities {
  std::string_view engine;
  std::string_view scheme = {};  ///< the one it steps by; empty: any of kernels/physics/schemes
  bool own_scheme = false;       ///< no other engine has that scheme

  WhyNot implicit_schemes = {};     ///< that solve an equation for all disks together
  WhyNot paper_time_step = {};      ///< integration.time_step = "paper"
  WhyNot nonlinear_laws = {};       ///< damping that is not linear in the velocity
  WhyNot overdamped_contacts = {};  ///< contacts that do not end of themselves
  WhyNot other_repulsions = {};     ///< that are not harmonic
  WhyNot drives = {};
  WhyNot ramps = {};
  WhyNot pieces = {};    ///< at whose beginning motions keep their excess over the mean flow
  WhyNot contacts = {};  ///< measure.contacts
  WhyNot profiles = {};
  WhyNot bias = {};     ///< measure.bias
  WhyNot devices = {};  ///< backends with memory of their own
};

/// All engines, in the order of the list of words of integration.engine.
std::span<Abilities const> all_engines();

/// Abilities of the engine that a scene asks for; those of "auto" if there is none of that name.
Abilities const& abilities_of(Scene const& scene);

/// True if events, and steps of all disks, can take turns in a scene.
bool can_take_turns(Scene const& scene);

/// True if the scheme belongs to one engine, which needs no time step to be stable.
bool is_scheme_of_an_engine(std::string_view scheme);

/// Refusals of what a scene asks for and an engine with these abilities cannot run.
std::vector<Refusal> why_not(Scene const& scene, Abilities const& abilities);

/// Refusals by the engine of the scene, and of a scheme that belongs to another engine.
std::vector<Refusal> why_not(Scene const& scene);

}  // namespace bagnold
