// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "src/config/names.hpp"
#include "src/run/rounded.hpp"
#include "src/run/warnings/checks.hpp"

namespace bagnold {

namespace {

std::string in_words(std::string_view name, bias::Bias const& bias) {
  return fmt::format("{} {}%", name, rounded_bias(bias.value, bias.error));
}

/// "p +4.8(9)%, sigma +6.2(12)%, Z -0.2(1)%, T_g -6.5(9)%"
std::string all_in_words(bias::Judgement const& of) {
  std::string words;
  for (std::size_t q = 0; q <= bias::temperature; ++q)
    words += (q == 0 ? "" : ", ") + in_words(bias::quantity_names[q], of.stated[q]);
  return words;
}

}  // namespace

std::optional<Warning> method_bias(FinishedRun const& finished) {
  auto const& run = finished.run;
  if (!run.bias || run.bias->judgement.verdict == bias::Verdict::accepted ||
      run.bias->judgement.verdict == bias::Verdict::usual)
    return {};
  auto const& found = *run.bias;
  Warning warning{"method_bias",
                  {{"pairs", static_cast<double>(found.pairs)}, {"accuracy", found.tolerance}},
                  {},
                  {}};
  if (found.pairs < 2) {
    warning.reason =
        fmt::format("the bias of the method is not known, of {} pairs of stretches", found.pairs);
  } else {
    for (std::size_t q = 0; q <= bias::temperature; ++q) {
      std::string const name(bias::quantity_names[q]);
      warning.numbers.emplace_back(name, found.judgement.stated[q].value);
      warning.numbers.emplace_back(name + "_error", found.judgement.stated[q].error);
    }
    bool const refused = found.judgement.verdict == bias::Verdict::refused;
    warning.reason = fmt::format(
        "{} pairs of stretches {} integration.accuracy = {}: {}", found.pairs,
        refused ? "show a bias beyond" : "do not tell whether the bias of the method is within",
        found.tolerance, all_in_words(found.judgement));
  }
  if (found.reason == "events") {
    warning.remedy = "steps alone have a bias; events, which step this flow, have none of a step";
    warning.command = "bagnold run DIR/scene.toml --set integration.engine=steps --out DIR-steps";
  } else if (found.judgement.verdict != bias::Verdict::refused) {
    warning.remedy =
        "a longer run or more disks tell more; the default scheme and step need no change for it";
    auto const most = static_cast<double>(bias::most_pairs(found.tolerance));
    double const more = found.pairs < 2 ? 2 : most / static_cast<double>(found.pairs);
    warning.command = longer_run(run, std::max(1.5, more));
  } else if (is_implicit(found.methods.coarse.integration.scheme)) {
    warning.remedy = "take the default scheme, or a shorter step";
    warning.command = fmt::format(
        "bagnold run DIR/scene.toml --set integration.scheme={} --set integration.time_step=auto "
        "--set integration.skin=auto --out DIR-scheme",
        default_scheme);
  } else {
    warning.remedy = "halve the time step";
    warning.command = half_the_step(finished);
  }
  return warning;
}

}  // namespace bagnold
