// SPDX-License-Identifier: BSD-3-Clause
#include "src/cli/analyse_options.hpp"

#include <fmt/format.h>

#include "src/analysis/kinds/kinds.hpp"
#include "src/cli/name_value.hpp"
#include "src/cli/options.hpp"

namespace bagnold {
namespace {

void add_axes(Words command, analysis::Request& request) {
  command.option("--x", request.x,
                 "quantity to the right: a key, an observable, phi_J-phi, A/B, A*B");
  command.option("--y", request.y, "quantity upwards");
  command.option("--along", request.along, "key that runs along a curve [x, or phi]");
  command.option("--by", request.by, "keys that tell curves apart [all others that vary]");
  command
      .option(
          "--where", [&](auto const& pairs) { request.where = name_values(pairs, "--where"); },
          "KEY=VALUE: only these points; may be repeated")
      .one_value_each();
  command.option("--range", request.range, "LOW HIGH: only x between");
  command.option("--first", request.first, "only so many points of smallest x [0: all]");
  command.flag("--log-x", request.log_x, "straight lines in ln x (kink, transition)");
  command.flag("--log-y", request.log_y, "straight lines in ln y (kink, transition)");
}

void add_fit(Words command, analysis::Request& request) {
  command.option("--phi-j", request.phi_j, "phi_J: fixed in a divergence, used by phi_J-phi");
  command
      .option(
          "--fix", [&](auto const& pairs) { request.fixed = name_numbers(pairs, "--fix"); },
          "NAME=VALUE: a parameter that is not fitted; may be repeated")
      .one_value_each();
  command.option("--of", request.of, "divergence: crossover, jump, transition or value");
  command.option("--weigh", request.weigh,
                 "divergence: places by their errors or alike (in ln); auto: alike where the law "
                 "that they come from is not exact [auto]");
  command.option("--kinks", request.kinks, "kink: 1 or 2 [1]");
  command.flag("--curved", request.curved, "kink: between curved branches, which make none");
  command.option("--direction", request.direction,
                 "jump, kink --curved (the first): up, down or both [both]");
  command.option("--least-factor", request.least_factor, "jump: by which y changes at least [2]")
      .between(1.0, 1e12);
  command.option("--rates", request.rates, "transition: two strain rates [the smallest two]")
      .values(2);
  command.option("--split", request.split, "transition: x between the two lines [best fit]");
  command.option("--pressure", request.pressure, "constant-pressure: P, [m/tau_e^2]");
  command.option("--window", request.window, "exponents: points a slope is taken over [3]");
  command.option("--resamples", request.resamples, "of the bootstrap; 0: none [400]")
      .between(0, 100000);
  command.option("--seed", request.seed, "of the bootstrap [1]");
}

/// Text of --help on the kinds of analysis.
std::string analyse_kinds() {
  std::string out = "Kinds of analysis (docs/analysis.md):\n";
  for (auto const& kind : analysis::kinds()) {
    out += fmt::format("  {:<18} {}\n", kind.name, kind.equation);
    if (!kind.source.empty()) out += fmt::format("  {:<18} {}\n", "", kind.source);
    out += fmt::format("  {:<18} {}\n", "", kind.options);
  }
  return out +
         "Written: PREFIX.csv (what was found), PREFIX.drawn.csv (what the picture shows), "
         "PREFIX.png, or .pdf, .svg by --format.\nUnits: length d_s, time tau_e; stresses in "
         "m/tau_e^2.";
}

}  // namespace

void add_analyse_options(Words command, AnalyseOptions& options) {
  command.footer(analyse_kinds());
  command.option("KIND", options.asked.kind, "what to find, see below").required();
  command.option("SWEEP", options.sweeps, "folder of a sweep, or sweep.h5; several are joined")
      .required();
  command.option("--out", options.prefix, "prefix of the files written [first SWEEP/KIND]");
  add_picture_format(command, options.format);
  add_axes(command, options.asked.request);
  add_fit(command, options.asked.request);
  command.flag("--quiet", options.quiet, "no table; errors and remarks are still shown");
}

}  // namespace bagnold
