// SPDX-License-Identifier: BSD-3-Clause
#include "src/cli/analyse_options.hpp"

#include <memory>

#include "src/cli/name_value.hpp"
#include "src/cli/options.hpp"

namespace bagnold {
namespace {

void add_axes(CLI::App& command, analysis::Request& request) {
  command.add_option("--x", request.x,
                     "quantity to the right: a key, an observable, phi_J-phi, A/B, A*B");
  command.add_option("--y", request.y, "quantity upwards");
  command.add_option("--along", request.along, "key that runs along a curve [x, or phi]");
  command.add_option("--by", request.by, "keys that tell curves apart [all others that vary]");
  command
      .add_option_function<std::vector<std::string>>(
          "--where", [&](auto const& pairs) { request.where = name_values(pairs, "--where"); },
          "KEY=VALUE: only these points; may be repeated")
      ->allow_extra_args(false);
  command.add_option("--range", request.range, "LOW HIGH: only x between");
  command.add_option("--first", request.first, "only so many points of smallest x [0: all]");
  command.add_flag("--log-x", request.log_x, "straight lines in ln x (kink, transition)");
  command.add_flag("--log-y", request.log_y, "straight lines in ln y (kink, transition)");
}

void add_fit(CLI::App& command, analysis::Request& request) {
  command.add_option("--phi-j", request.phi_j, "phi_J: fixed in a divergence, used by phi_J-phi");
  command
      .add_option_function<std::vector<std::string>>(
          "--fix", [&](auto const& pairs) { request.fixed = name_numbers(pairs, "--fix"); },
          "NAME=VALUE: a parameter that is not fitted; may be repeated")
      ->allow_extra_args(false);
  command.add_option("--of", request.of, "divergence: crossover, jump, transition or value");
  command.add_option("--kinks", request.kinks, "kink: 1 or 2 [1]");
  command.add_option("--direction", request.direction, "jump: up, down or both [both]");
  command
      .add_option("--least-factor", request.least_factor, "jump: by which y changes at least [2]")
      ->check(CLI::Range(1.0, 1e12));
  command.add_option("--rates", request.rates, "transition: two strain rates [the smallest two]")
      ->expected(2);
  command.add_option("--split", request.split, "transition: x between the two lines [best fit]");
  command.add_option("--pressure", request.pressure, "constant-pressure: P, [m/tau_e^2]");
  command.add_option("--window", request.window, "exponents: points a slope is taken over [3]");
  command.add_option("--resamples", request.resamples, "of the bootstrap; 0: none [400]")
      ->check(CLI::Range(0, 100000));
  command.add_option("--seed", request.seed, "of the bootstrap [1]");
}

}  // namespace

void add_analyse_options(CLI::App& command, AnalyseOptions& options) {
  command.footer(analyse_kinds());
  command.add_option("KIND", options.kind, "what to find, see below")->required();
  command.add_option("SWEEP", options.sweep, "folder of a sweep, or sweep.h5")->required();
  command.add_option("--out", options.prefix, "prefix of the files written [SWEEP/KIND]");
  add_axes(command, options.request);
  add_fit(command, options.request);
  command.add_flag("--quiet", options.quiet, "no table; errors and remarks are still shown");
}

Command add_analyse(CLI::App& program) {
  auto const options = std::make_shared<AnalyseOptions>();
  CLI::App& command = add_command(program, "analyse", "fits and phase boundaries from a sweep");
  add_analyse_options(command, *options);
  return {&command, [options] { return analyse_command(*options); }};
}

}  // namespace bagnold
