// SPDX-License-Identifier: BSD-3-Clause
#include "src/cli/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "src/config/ladder.hpp"
#include "src/config/laws.hpp"
#include "src/config/schemes.hpp"
#include "src/run/bias/course.hpp"
#include "src/run/bias/methods.hpp"
#include "src/run/paper_values.hpp"
#include "src/run/protocols/ramp/hysteresis.hpp"
#include "src/run/protocols/sequence/piece_results.hpp"
#include "src/run/protocols/stress/stress_results.hpp"
#include "src/run/rounded.hpp"
#include "src/run/target_error.hpp"
#include "src/run/warnings/warning.hpp"

namespace bagnold {

namespace {

std::string with_error(statistics::Estimate const& estimate) {
  if (!estimate.mean) return "undefined";
  if (!estimate.error) return fmt::format("{:.4g} (no error)", *estimate.mean);
  return rounded(*estimate.mean, *estimate.error) + (estimate.rough ? " (rough)" : "");
}

/// ", method +0.02(3)%", or "" where no bias is known.
std::string with_bias(Run const& run, std::string_view name) {
  auto const bias = bias_of(run, name);
  return bias ? fmt::format(", method {}%", rounded_bias(bias->value, bias->error)) : "";
}

/// Estimate of a name with its error, where observables and estimates stand side by side.
template <class Averages>
std::string with_error(Averages const& of, std::string_view name) {
  auto const at = std::ranges::find(of.observables, name, &Observable::name);
  return with_error(of.estimates[static_cast<std::size_t>(at - of.observables.begin())]);
}

/// True for the observables of the short table. B is constant in Bagnold's rheology. eta is
/// constant in Newton's, which damping along the normal alone does not have.
bool is_short(Scene const& scene, std::string_view name) {
  constexpr std::string_view always[] = {"p",
                                         "sigma",
                                         "mu",
                                         "Z",
                                         "T_g",
                                         "B_p",
                                         "B_sigma",
                                         "tau_dur",
                                         "nu_coll",
                                         "G_storage",
                                         "G_loss",
                                         "G_storage_3",
                                         "G_loss_3",
                                         "band_fraction_phi",
                                         "band_fraction_gammadot"};
  if (std::ranges::count(always, name) > 0) return true;
  if (scene.shear.target_error.contains(std::string(name))) return true;
  return (name == "eta_p" || name == "eta_sigma") &&
         law_of(scene.disks).constants(scene.disks).tangential > 0;
}

/// Shear stress up and down, every few rates.
void print_loop(Run const& run) {
  Loop const loop = loop_of(run);
  auto const sigma = [](LoopBin const& bin) { return with_error(bin, "sigma"); };
  fmt::print("\n{:<13} {:<28} {}\n", "strain rate", "sigma up [m/tau_e^2]", "sigma down");
  for (std::size_t k = 0; k < std::min(loop.up.size(), loop.down.size());
       k += loop_bins_a_decade / 4)
    fmt::print("{:<13.3g} {:<28} {}\n", loop.up[k].strain_rate, sigma(loop.up[k]),
               sigma(loop.down[k]));
}

/// Each piece of a sequence: what it was and what it met.
void print_pieces(Run const& run) {
  auto const pieces = piece_results(run);
  fmt::print("\n{:<12} {:<10} {:<10} {:<24} {:<24} {:<14} {}\n", "strain rate", "strain", "time",
             "p [m/tau_e^2]", "sigma [m/tau_e^2]", "Z", "windows");
  for (auto const& piece : pieces)
    fmt::print("{:<12.4g} {:<10.4g} {:<10.4g} {:<24} {:<24} {:<14} {}\n", piece.strain_rate,
               piece.strain, piece.time, with_error(piece, "p"), with_error(piece, "sigma"),
               with_error(piece, "Z"), piece.windows);
}

/// Each stress of several.
void print_stresses(Run const& run) {
  fmt::print("\n{:<18} {:<12} {:<24} {:<24} {:<20} {:<14} {}\n", "stress [m/tau_e^2]", "strain",
             "strain rate [1/tau_e]", "p [m/tau_e^2]", "mu", "Z", "windows");
  for (auto const& one : stress_results(run))
    fmt::print("{:<18.4g} {:<12.4g} {:<24} {:<24} {:<20} {:<14} {}\n", one.stress, one.strain,
               with_error(one, "strain_rate"), with_error(one, "p"), with_error(one, "mu"),
               with_error(one, "Z"), one.windows);
}

/// "; `command`", to be typed with this folder; "" where there is none.
std::string typed(std::string const& command, std::string const& folder) {
  if (folder.empty() || command.empty()) return {};
  return fmt::format("; `{}`", with_folder(command, folder));
}

/// Prints where a run with target errors ended, and how much "auto" discarded.
void print_ends(Run const& run, std::string const& folder) {
  if (!run.scene.shear.discard)
    fmt::print("\nsteady {} (MSER-5): {} of {} windows discarded\n",
               run.steady_found
                   ? "state found"
                   : "state not found, so half discarded" + typed(longer_run(run, 2), folder),
               run.plan.discarded_windows, run.plan.windows);
  for (auto const& [name, error] : run.reached)
    fmt::print("relative error of {}: {} wanted, {} reached at strain {:.4g}\n", name,
               run.scene.shear.target_error.at(name),
               error ? fmt::format("{:.3g}", *error) : "none", run.plan.path(run.plan.steps));
  if (!run.reached.empty() && !run.target_met)
    fmt::print("not reached at two looks in a row{}\n", typed(until_target(run), folder));
}

/// Prints which names have no error or a rough one, and what to do about it.
void print_remarks(FinishedRun const& finished, std::string const& folder) {
  std::set<std::string> remarks;
  int none = 0, rough = 0;
  for (auto const& named : finished.found)
    if (auto const& all = named.estimate.all; !all.remark.empty()) {
      ++(all.error ? rough : none);
      remarks.insert(all.remark);
    }
  if (remarks.empty()) return;
  double const fewest = fewest_independent_windows(finished);
  auto const why = std::isfinite(fewest)
                       ? fmt::format(
                             "the shortest is worth {:.2g} independent windows, of {:g} that an "
                             "error takes{}",
                             fewest, enough_windows, typed(until_errors(finished), folder))
                       : *remarks.begin();
  fmt::print("\n{} of {} quantities have no error, {} a rough one (with Student's factor): {}\n",
             none, finished.found.size(), rough, why);
}

/// The method of the run, its verdict, and other methods that were tried.
void print_method(bias::Findings const& found, Scene const& scene) {
  fmt::print("\n");
  for (auto const& one : found.tried)
    fmt::print(
        "{}: {}: {}{}{}\n", one.taken ? "left" : "not taken",
        bias::method_in_words(one.methods.coarse), one.reason,
        one.reason == bias::inertia
            ? fmt::format(" (p_kin/p above {:g})", one.taken ? most_kinetic : least_inertia(scene))
            : "",
        one.reason.empty() ? fmt::format("{} after {} pairs of stretches",
                                         bias::name_of(one.judgement.verdict), one.pairs)
                           : "");
  if (scene.integration.scheme == automatic)
    fmt::print("method: {}\n", bias::method_in_words(found.methods.coarse));
  if (found.judgement.verdict == bias::Verdict::usual)
    fmt::print("bias of the method: not measured (below {:g}% in all flows of docs/accuracy.md)\n",
               100 * usual_accuracy);
  else
    fmt::print("bias of the method: {} within {:g}% after {} pairs of stretches\n",
               found.judgement.verdict == bias::Verdict::none
                   ? "not known to be"
                   : bias::name_of(found.judgement.verdict),
               100 * found.tolerance, found.pairs);
}

}  // namespace

void print_table(Run const& run, std::vector<NamedEstimate> const& list, std::string const& folder,
                 bool all_of_them) {
  if (run.plan.ramp) return print_loop(run);
  if (run.scene.shear.lists_pieces()) return print_pieces(run);
  if (run.plan.stages > 1) return print_stresses(run);
  bool const stated = run.bias && run.bias->pairs > 1;
  int const width = stated ? 42 : 26;
  fmt::print("\n{:<13} {:<{}} {:<17} {:<19} {}\n", "quantity",
             stated ? "mean(standard error), bias of method" : "mean(standard error)", width,
             "unit", "correlation strain", "what it is");
  std::size_t left_out = 0;
  for (auto const& named : list) {
    auto const& [name, unit, meaning, value] = named.observable;
    if (!all_of_them && !is_short(run.scene, name)) {
      ++left_out;
      continue;
    }
    auto const& all = named.estimate.all;
    fmt::print(
        "{:<13} {:<{}} {:<17} {:<19} {}\n", name, with_error(all) + with_bias(run, name), width,
        unit, all.correlation ? fmt::format("{:.2g}", *all.correlation * named.sample_strain) : "-",
        meaning);
  }

  if (left_out > 0) fmt::print("{} more in summary.json (on the screen with --all)\n", left_out);

  print_ends(run, folder);
  if (run.bias) print_method(*run.bias, run.scene);
  if (run.replicas.size() > 1)
    fmt::print("\n{} replicas, seeds {} to {}; errors: {}\n", run.replicas.size(),
               run.scene.disks.seed,
               run.scene.disks.seed + static_cast<std::int64_t>(run.replicas.size()) - 1,
               errors_from(run));

  print_remarks({run, list}, folder);

  std::vector<Observable> only;
  for (auto const& named : list) only.push_back(named.observable);
  auto const papers = paper_values(run.scene, only);
  if (papers.empty()) return;
  fmt::print("\n{:<18} {:<26} {:<28} {}\n", "quantity", "ours", "the paper", "where");
  for (auto const& paper : papers)
    fmt::print("{:<18} {:<26} {:<28} {}\n", paper.quantity,
               with_error(estimate(run, paper.value).all), paper.stated, paper.source);
}

}  // namespace bagnold
