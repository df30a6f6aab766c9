// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>

#include "src/cli/exit_code.hpp"
#include "src/cli/options.hpp"
#include "src/config/errors.hpp"
#include "src/config/grain_units.hpp"
#include "src/config/shown.hpp"

namespace bagnold {

namespace {

using Factors = std::map<std::string, double>;

Factors const lengths = {{"", 1}, {"m", 1}, {"cm", 1e-2}, {"mm", 1e-3}, {"um", 1e-6}, {"nm", 1e-9}};
Factors const densities = {{"", 1}, {"kg/m3", 1}, {"kg/m^3", 1}, {"g/cm3", 1e3}, {"g/cm^3", 1e3}};
Factors const pressures = {{"", 1}, {"Pa", 1}, {"kPa", 1e3}, {"MPa", 1e6}, {"GPa", 1e9}};
Factors const speeds = {{"", 1}, {"m/s", 1}, {"cm/s", 1e-2}, {"mm/s", 1e-3}};
Factors const rates = {{"", 1}, {"1/s", 1}, {"/s", 1}, {"Hz", 1}};

/// "2mm" in SI. InputError with the option's name.
double quantity(std::string const& option, std::string const& text, Factors const& factors,
                char const* example) {
  double value = 0;
  auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  std::string unit(end, text.data() + text.size());
  unit.erase(0, unit.find_first_not_of(' ') == std::string::npos ? 0 : unit.find_first_not_of(' '));
  if (error == std::errc() && value > 0 && std::isfinite(value) && factors.contains(unit))
    return value * factors.at(unit);
  std::string known;
  for (auto const& [name, factor] : factors)
    if (!name.empty()) known += (known.empty() ? "" : ", ") + name;
  throw InputError(
      fmt::format("{} = {} (must be a number above 0 with one of the units {}, or in SI); as {} {}",
                  option, shown(text), known, option, example));
}

struct Options {
  std::string diameter, density, modulus, speed = "0.1", rate, mass = "equal";
  double poisson = 0.3, restitution = 0.9;
};

int units_command(Options const& options) {
  double const disk_mass = options.mass == "area" ? std::numbers::pi / 2 : 1;
  Grains const grains{.diameter = quantity("--diameter", options.diameter, lengths, "2mm"),
                      .density = quantity("--density", options.density, densities, "2500"),
                      .modulus = quantity("--modulus", options.modulus, pressures, "65GPa"),
                      .poisson = options.poisson,
                      .speed = quantity("--speed", options.speed, speeds, "0.1"),
                      .restitution = options.restitution};
  auto const units = units_of(grains, disk_mass);
  fmt::print("# spheres of {:g} m, {:g} kg/m^3, {:g} Pa, that meet at {:g} m/s\n", grains.diameter,
             grains.density, grains.modulus, grains.speed);
  fmt::print("# d_s            {:.3g} m\n", grains.diameter);
  fmt::print("# tau_e          {:.3g} s; a collision lasts {:.3g} s\n", units.time, units.duration);
  fmt::print("# m              {:.3g} kg\n", units.mass);
  fmt::print("# velocity 1     {:.3g} m/s\n", grains.diameter / units.time);
  fmt::print("# pressure 1     {:.3g} N/m, over a layer of one diameter {:.3g} Pa\n",
             units.pressure(), units.pressure() / grains.diameter);
  fmt::print("# strain_rate 1  {:.3g} 1/s\n\n", 1 / units.time);
  fmt::print("[disks]\nmass = \"{}\"\nelasticity = {:.3g}\n", options.mass, units.elasticity);
  if (!options.rate.empty())
    fmt::print("\n[shear]\nstrain_rate = {:.3g}\n",
               quantity("--rate", options.rate, rates, "10") * units.time);
  return done;
}

}  // namespace

Command add_units(Words program) {
  auto const options = std::make_shared<Options>();
  Words command =
      add_command(program, "units", "Q, rates and units of a scene for grains of a material");
  command.option("--diameter", options->diameter, "of a small grain, as 2mm").required();
  command.option("--density", options->density, "in kg/m3, or as 2.5g/cm3").required();
  command.option("--modulus", options->modulus, "Young's, as 65GPa").required();
  command.option("--poisson", options->poisson, "Poisson's number [0.3]").between(0.0, 0.5);
  command.option("--restitution", options->restitution, "of a head-on collision [0.9]")
      .between(0.01, 0.999);
  command.option("--speed", options->speed, "at which grains meet, in m/s [0.1]");
  command.option("--rate", options->rate, "strain rate, in 1/s, to be told in 1/tau_e");
  command.option("--mass", options->mass, "of disks: equal (P2) or area (P1) [equal]")
      .one_of({"equal", "area"});
  return {command, [options] { return units_command(*options); }};
}

}  // namespace bagnold
