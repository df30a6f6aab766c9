// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/names.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "kernels/physics/laws/cd_nt.hpp"
#include "kernels/physics/repulsion/repulsion.hpp"
#include "kernels/physics/schemes/schemes.hpp"
#include "kernels/physics/type_list.hpp"
#include "src/config/abilities.hpp"
#include "src/config/drives.hpp"
#include "src/config/laws.hpp"
#include "src/config/schemes.hpp"

namespace bagnold {

namespace {

/// Names of the laws that satisfy a condition.
template <class Holds>
Names laws_where(Holds const& holds) {
  Names names;
  for (auto const& law : known_laws())
    if (holds(law)) names.push_back(law.name);
  return names;
}

std::string either(std::vector<std::string> const& parts) {
  if (parts.size() < 2) return parts.empty() ? "" : parts.front();
  return fmt::format("{} or {}", fmt::join(parts.begin(), parts.end() - 1, ", "), parts.back());
}

std::string damping_meaning(std::string_view constant) {
  return fmt::format("{}, model {} only", constant, fmt::join(separate_models(), ", "));
}

}  // namespace

Names model_names() {
  return laws_where([](LawFacts const&) { return true; });
}

Names rotating_models() {
  return laws_where([](LawFacts const& law) { return law.rotates; });
}

Names separate_models() {
  return laws_where([](LawFacts const& law) { return law.separate_constants; });
}

Names acting_drives() {
  Names names;
  for (auto const& drive : known_drives()) names.push_back(drive.name);
  return names;
}

Names drive_words() {
  Names words = acting_drives();
  words.insert(words.begin(), no_drive);
  return words;
}

Names thermal_drives() {
  Names names;
  for (auto const& drive : known_drives())
    if (drive.thermal) names.push_back(drive.name);
  return names;
}

bool is_implicit(std::string_view scheme) {
  return with_named<Schemes>(scheme,
                             []<class S>(std::type_identity<S>) { return ImplicitScheme<S>; });
}

Names scheme_words() {
  Names words = names_of<Schemes>();
  words.insert(words.begin(), automatic);
  for (auto const& engine : all_engines())
    if (engine.own_scheme) words.push_back(engine.scheme);
  return words;
}

Names engine_words() {
  Names words;
  for (auto const& one : all_engines()) words.push_back(one.engine);
  return words;
}

std::vector<double> force_exponents() {
  std::vector<double> exponents;
  for_each_type<Repulsions>(
      [&]<class R>(std::type_identity<R>) { exponents.push_back(R::force_exponent); });
  std::ranges::sort(exponents);
  return exponents;
}

std::string const& exponent_meaning() {
  static std::string const meaning = "alpha: " + exponent_choice();
  return meaning;
}

std::string const& normal_damping_meaning() {
  static std::string const meaning = damping_meaning("k_d^(n)");
  return meaning;
}

std::string const& tangential_damping_meaning() {
  static std::string const meaning = damping_meaning("k_d^(t)");
  return meaning;
}

std::string choice(Names const& words) {
  std::vector<std::string> parts;
  for (auto const word : words) parts.push_back(fmt::format("\"{}\"", word));
  return either(parts);
}

std::string exponent_choice() {
  std::vector<std::string> parts;
  for_each_type<Repulsions>([&]<class R>(std::type_identity<R>) {
    parts.push_back(fmt::format("{} ({})", R::force_exponent, R::name));
  });
  return either(parts);
}

}  // namespace bagnold
