// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Names in the lists of laws, repulsions and schemes in kernels/physics, for code that needs no
/// formulas.
namespace bagnold {

using Names = std::vector<std::string_view>;

Names model_names();      ///< of all laws
Names rotating_models();  ///< of laws with spins
Names separate_models();  ///< of laws with a damping constant of their own in either direction
Names acting_drives();    ///< names of all drives but "none"
Names drive_words();      ///< "none", and these
Names thermal_drives();   ///< of drives that have a temperature
Names scheme_words();     ///< "auto", the names of all schemes, and those of single engines
Names protocol_names();   ///< of shear.protocol
Names engine_words();     ///< of integration.engine, "auto" first

/// True if a scheme solves an equation for the motions of all disks together.
bool is_implicit(std::string_view scheme);

std::vector<double> force_exponents();  ///< of all repulsions, rising

/// Meanings of keys that name a choice.
std::string const& exponent_meaning();
std::string const& normal_damping_meaning();
std::string const& tangential_damping_meaning();

/// "a" or "b", as messages name choices.
std::string choice(Names const& words);
std::string exponent_choice();  ///< 2 (harmonic) or 2.5 (Hertz)

}  // namespace bagnold
