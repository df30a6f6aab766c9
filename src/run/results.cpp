// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/results.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>

#include "src/config/keys.hpp"
#include "src/config/oscillation.hpp"
#include "src/config/scene_file.hpp"
#include "src/config/strain_rates.hpp"
#include "src/config/time_step.hpp"
#include "src/engine/control_columns.hpp"
#include "src/engine/levels/levels.hpp"
#include "src/io/atomic_file.hpp"
#include "src/io/result_file.hpp"
#include "src/run/protocols/oscillate/cycles.hpp"
#include "src/run/protocols/ramp/hysteresis.hpp"
#include "src/run/protocols/sequence/piece_results.hpp"
#include "src/run/protocols/stress/stress_results.hpp"
#include "src/run/provenance.hpp"
#include "src/run/target_error.hpp"
#include "src/run/warnings/warning.hpp"
#include "src/statistics/stopping.hpp"

namespace bagnold {

namespace {

using Json = nlohmann::ordered_json;

Json number(std::optional<double> const& value) {
  return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

Json scene_json(Scene const& scene) {
  Json all = Json::object();
  for_each_key(scene, [&](Key const& key, auto const& member) {
    if (!belongs(key, scene.shear.protocol)) return;
    using Member = std::decay_t<decltype(member)>;
    Json value;
    if constexpr (std::is_same_v<Member, std::optional<double>>)
      value = member ? Json(*member) : Json("auto");
    else if constexpr (std::is_same_v<Member, NumberOrWord>)
      value = member.number ? Json(*member.number) : Json(member.word);
    else if constexpr (std::is_same_v<Member, NumberOrList>)
      value = member.is_list() ? Json(member.each) : Json(member.at(0));
    else if constexpr (std::is_same_v<Member, std::vector<SequencePiece>>)
      for (auto const& piece : member) value.push_back({piece.rate, piece.amount});
    else
      value = member;
    auto const dot = key.name.find('.');
    if (dot == std::string_view::npos)
      all[std::string(key.name)] = value;
    else
      all[std::string(key.name.substr(0, dot))][std::string(key.name.substr(dot + 1))] = value;
  });
  return all;
}

/// Step after the last one of a window.
std::int64_t end_of(Run const& run, std::size_t window) {
  return run.plan.window_end(static_cast<std::int64_t>(window));
}

double rate_of(Run const& run, std::size_t window) {
  return run.plan.mean_rate(static_cast<std::int64_t>(window));
}

/// Mean strain rate of a replica in a window; a controller may have chosen its own.
double rate_of(Run const& run, Replica const& replica, std::size_t window) {
  if (!run.plan.by_time) return rate_of(run, window);
  auto const& windows = replica.measurement.windows;
  return windows.row(
             window)[windows.columns - ControlColumns::count + ControlColumns::strain_rate] /
         windows.weight[window];
}

/// Largest number of windows of a replica; all have as many once the run is done.
std::size_t most_windows(Run const& run) {
  std::size_t most = 0;
  for (auto const& replica : run.replicas)
    most = std::max(most, replica.measurement.windows.size());
  return most;
}

std::size_t discarded(Run const& run) {
  return std::min(static_cast<std::size_t>(run.plan.discarded_windows), most_windows(run));
}

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Adds the records of all replicas: under each name a number, or a row of R. NaN where a replica
/// has no such name: engine = "auto" may have chosen another engine for it.
void add_records(Run const& run, std::map<std::string, double> Replica::*record,
                 std::string const& prefix, io::Attributes& attributes) {
  std::set<std::string> names;
  for (auto const& replica : run.replicas)
    for (auto const& [name, value] : replica.*record) names.insert(name);
  for (auto const& name : names) {
    std::vector<double> values;
    for (auto const& replica : run.replicas) {
      auto const found = (replica.*record).find(name);
      values.push_back(found == (replica.*record).end() ? nan : found->second);
    }
    io::Value value = values;
    if (values.size() == 1) value = values.front();
    attributes.push_back({prefix + name, std::move(value)});
  }
}

std::vector<std::int64_t> seeds(Run const& run) {
  std::vector<std::int64_t> list(run.replicas.size());
  std::iota(list.begin(), list.end(), run.scene.disks.seed);
  return list;
}

std::vector<statistics::Windows const*> windows_of(Run const& run) {
  std::vector<statistics::Windows const*> windows;
  for (auto const& replica : run.replicas) windows.push_back(&replica.measurement.windows);
  return windows;
}

std::vector<Frames const*> frames_of(Run const& run) {
  std::vector<Frames const*> frames;
  for (auto const& replica : run.replicas) frames.push_back(&replica.measurement.frames);
  return frames;
}

/// Series of value(replica, window): NaN where a replica has not reached that window yet.
template <class Value>
io::Series series(Run const& run, std::string_view name, std::string_view unit,
                  std::string_view meaning, Value const& value) {
  io::Series made{std::string(name), std::string(unit), std::string(meaning), {}};
  auto const windows = most_windows(run);
  made.value.reserve(windows * run.replicas.size());
  for (auto const& replica : run.replicas)
    for (std::size_t w = 0; w < windows; ++w)
      made.value.push_back(w < replica.measurement.windows.size() ? value(replica, w) : nan);
  return made;
}

}  // namespace

double path_of(Run const& run, std::size_t windows) {
  if (windows == 0) return 0;
  if (!run.plan.by_time) return run.plan.path(end_of(run, windows - 1));
  double sum = 0;
  for (auto const& replica : run.replicas)
    for (std::size_t w = 0; w < windows; ++w)
      sum += std::abs(rate_of(run, replica, w)) * run.plan.time_step *
             static_cast<double>(run.plan.window_steps);
  return sum / static_cast<double>(run.replicas.size());
}

std::vector<double> strains_of(Run const& run, Replica const& replica) {
  std::vector<double> strains;
  double strain = 0;
  double const time = run.plan.time_step * static_cast<double>(run.plan.window_steps);
  for (std::size_t w = 0; w < replica.measurement.windows.size(); ++w)
    strains.push_back(run.plan.by_time ? strain += rate_of(run, replica, w) * time
                                       : run.plan.strain(end_of(run, w)));
  return strains;
}

statistics::ReplicaEstimate estimate(Run const& run, statistics::Function const& f) {
  auto const windows = windows_of(run);
  auto found = statistics::estimate(windows, discarded(run), f);
  if (!run.scene.shear.target_error.empty()) found.all = statistics::cautious(found);
  return found;
}

std::optional<bias::Bias> bias_of(Run const& run, std::string_view name) {
  if (!run.bias || run.bias->pairs < 2) return {};
  constexpr std::pair<std::string_view, bias::Quantity> known[] = {
      {"p", bias::pressure},           {"B_p", bias::pressure},
      {"eta_p", bias::pressure},       {"sigma", bias::shear_stress},
      {"B_sigma", bias::shear_stress}, {"eta_sigma", bias::shear_stress},
      {"mu", bias::friction},          {"T_g", bias::temperature},
      {"p_kin", bias::temperature},    {"B_p_kin", bias::temperature},
      {"Z", bias::contact_number}};
  for (auto const& [of, quantity] : known)
    if (of == name) return run.bias->judgement.stated[quantity];
  return {};
}

std::string errors_from(Run const& run) {
  std::string const source(statistics::error_source(run.replicas.size()));
  if (run.scene.shear.target_error.empty()) return source;
  if (run.replicas.size() < statistics::fewest_replicas) return source + ", with Student's factor";
  return source + " or blocks of windows in each, the larger one, with Student's factor";
}

namespace {

std::vector<NamedEstimate> estimates_of_cycles(Run const& run) {
  std::vector<NamedEstimate> list;
  auto const cycles = cycles_of(run);
  std::vector<statistics::Windows const*> tables;
  for (auto const& table : cycles.of) tables.push_back(&table);
  for (auto const& observable : cycles.observables)
    list.push_back({{observable, {}},
                    statistics::estimate(tables, cycles.discarded, observable.value),
                    run.plan.path(run.plan.pieces->cycle_steps())});
  return list;
}

}  // namespace

std::vector<NamedEstimate> estimates(Run const& run) {
  std::vector<NamedEstimate> list;
  if (run.scene.shear.oscillates()) return estimates_of_cycles(run);
  if (!run.plan.has_one_rate() || run.plan.stages > 1) return list;  // there is no one flow
  auto const windows = windows_of(run);
  auto const most = most_windows(run);
  double const window = run.plan.by_time && most > 0
                            ? path_of(run, most) / static_cast<double>(most)
                            : run.plan.strain(run.plan.window_steps);
  for (auto const& observable : observables(run.scene, run.box_length))
    list.push_back({{observable, windows}, estimate(run, observable.value), window});
  for (auto const& of_frames : Frames::observables(frames_of(run)))
    list.push_back({of_frames,
                    statistics::estimate(of_frames.samples, 0, of_frames.observable.value),
                    run.plan.strain(run.plan.frame_steps)});
  return list;
}

std::vector<double> window_series(Run const& run, Observable const& observable) {
  std::size_t windows = run.replicas.front().measurement.windows.size();
  for (auto const& replica : run.replicas)
    windows = std::min(windows, replica.measurement.windows.size());
  std::vector<double> series(windows, 0.0);
  for (auto const& replica : run.replicas)
    for (std::size_t w = 0; w < windows; ++w)
      series[w] += observable.value(replica.measurement.windows.mean(w, w + 1)) /
                   static_cast<double>(run.replicas.size());
  return series;
}

namespace {

/// All observables in every window, each at the window's rate.
void add_observables(Run const& run, std::vector<io::Series>& all) {
  std::vector<std::vector<Observable>> at_rate;  // [windows]; one for all at one rate
  Scene scene = run.scene;
  for (std::size_t w = 0; w == 0 || (run.plan.ramp && w < most_windows(run)); ++w) {
    scene.shear.strain_rate = rate_of(run, w);
    at_rate.push_back(observables(scene, run.box_length));
  }
  for (std::size_t k = 0; k < at_rate.front().size(); ++k) {
    auto const& first = at_rate.front()[k];
    if (first.name == "strain_rate") continue;  // stands there already
    all.push_back(series(run, first.name, first.unit, first.meaning,
                         [&](Replica const& replica, std::size_t w) {
                           auto const& here = at_rate[run.plan.ramp ? w : 0][k];
                           return here.value(replica.measurement.windows.mean(w, w + 1));
                         }));
  }
}

}  // namespace

void write_result_file(RunFolder const& folder, Run const& run) {
  io::Result result;
  Provenance const made = provenance();
  auto const& disks = run.scene.disks;
  result.attributes = {
      {"title", run.scene.title},
      {"bagnold_version", made.version},
      {"git", made.git},
      {"compiler", made.compiler},
      {"kokkos", made.kokkos},
      {"backend", run.backend},
      {"simd", std::string(level_of(run.scene.disks.model, run.scene.drive.kind).name)},
      {"scene", write_scene(run.scene)},
      {"model", disks.model},
      {"mass", disks.mass},
      {"count", disks.count},
      {"packing_fraction", disks.packing_fraction},
      {"elasticity", disks.elasticity},
      {"protocol", run.scene.shear.protocol},
      {"strain_rate", typical_rate(run.scene)},
      {"seed", disks.seed},
      {"box_length", run.box_length},
      {"box_aspect", disks.box_aspect},
      {"scheme", run.scene.integration.scheme},
      {"time_step", run.plan.time_step},
      {"steps", run.plan.steps},
      {"window_steps", run.plan.window_steps}};
  if (run.replicas.size() > 1) result.attributes.push_back({"seeds", seeds(run)});
  add_records(run, &Replica::start_record, "", result.attributes);
  add_records(run, &Replica::engine, "engine_", result.attributes);
  result.discarded_windows = static_cast<std::int64_t>(discarded(run));
  result.replicas = run.replicas.size();
  if (run.scene.shear.by_pieces()) result.axis = "time";  // the strain may come back

  std::map<Replica const*, std::vector<double>> strains;
  for (auto const& replica : run.replicas) strains[&replica] = strains_of(run, replica);
  auto const strain = [&](Replica const& replica, std::size_t w) {
    return strains.at(&replica)[w];
  };
  auto const time = [&](Replica const& replica, std::size_t w) {
    return replica.initial_time + run.plan.time_step * static_cast<double>(end_of(run, w));
  };
  result.series = {
      series(run, "strain", "1", "at the end of the window, from 0 at the start", strain),
      series(run, "time", "tau_e", "at the end of the window", time),
      series(run, "strain_rate", "1/tau_e", "gammadot, mean over the window",
             [&](Replica const& replica, std::size_t w) { return rate_of(run, replica, w); }),
      series(run, "evaluations", "1", "configurations evaluated in the window",
             [](Replica const& replica, std::size_t w) {
               return replica.measurement.windows.weight[w];
             })};
  if (run.plan.ramp)
    result.series.push_back(series(run, "direction", "1", "+1 up, -1 down, 0 before the ramp",
                                   [&](Replica const&, std::size_t w) {
                                     return run.plan.direction(static_cast<std::int64_t>(w));
                                   }));
  add_observables(run, result.series);
  auto found = Frames::join(frames_of(run));
  result.histograms = std::move(found.histograms);
  result.profiles = std::move(found.profiles);
  result.samples = std::move(found.samples);
  if (run.scene.shear.lists_pieces()) result.samples.push_back(piece_table(run));
  if (run.scene.shear.oscillates()) result.samples.push_back(cycle_table(run));
  io::write_result(folder.result(), result);
}

namespace {

/// JSON of one name of the summary. sample_strain: strain between samples.
Json estimate_json(statistics::Estimate const& of, double sample_strain) {
  auto const& tau = of.correlation;
  Json all{{"mean", number(of.mean)},
           {"error", number(of.error)},
           {"correlation_strain", tau ? number(*tau * sample_strain) : Json(nullptr)},
           {"samples", of.samples}};
  if (of.rough) all["rough"] = true;
  return all;
}

/// The same with the bias of the method, in the unit of the mean.
Json with_bias(Json all, statistics::Estimate const& of, std::optional<bias::Bias> const& bias) {
  if (!bias || !of.mean) return all;
  all["bias"] = number(bias->value * *of.mean);
  all["bias_error"] = number(bias->error * std::abs(*of.mean));
  return all;
}

Json method_json(Scene const& scene) {
  return {{"scheme", scene.integration.scheme}, {"time_step", time_step(scene)}};
}

Json biases_json(bias::Trial const& of) {
  Json all = Json::object();
  for (std::size_t q = 0; of.pairs > 1 && q < bias::quantities; ++q) {
    auto const& one = of.judgement.stated[q];
    all[std::string(bias::quantity_names[q])] = {{"bias", number(one.value)},
                                                 {"error", number(one.error)}};
  }
  return all;
}

Json trial_json(bias::Trial const& of) {
  Json all{{"method", method_json(of.methods.coarse)},
           {"verdict", bias::name_of(of.judgement.verdict)},
           {"pairs", of.pairs},
           {"relative", biases_json(of)}};
  if (!of.reason.empty()) all["reason"] = of.reason;
  return all;
}

Json bias_json(bias::Findings const& found) {
  Json all{{"verdict", bias::name_of(found.judgement.verdict)},
           {"accuracy", found.tolerance},
           {"pairs", found.pairs},
           {"stretch_strain", found.methods.strain()},
           {"method", method_json(found.methods.coarse)},
           {"finer", method_json(found.methods.fine)},
           {"dropped_strain", found.dropped_strain},
           {"steps", found.coarse_steps},
           {"finer_steps", found.fine_steps},
           {"gas", found.judgement.gas},
           {"relative", biases_json(found)},
           {"looks", Json::array()}};
  for (auto const& look : found.looks)
    all["looks"].push_back({{"pairs", look.pairs}, {"verdict", bias::name_of(look.verdict)}});
  for (auto const& trial : found.tried) all["tried"].push_back(trial_json(trial));
  return all;
}

Json list_json(std::vector<Observable> const& observables,
               std::vector<statistics::Estimate> const& estimates) {
  Json all = Json::object();
  for (std::size_t k = 0; k < observables.size(); ++k)
    all[std::string(observables[k].name)] = {{"mean", number(estimates[k].mean)},
                                             {"error", number(estimates[k].error)}};
  return all;
}

Json pieces_json(std::vector<PieceResult> const& pieces) {
  Json all = Json::array();
  for (auto const& piece : pieces)
    all.push_back({{"strain_rate", piece.strain_rate},
                   {"begin_strain", piece.begin_strain},
                   {"strain", piece.strain},
                   {"begin_time", piece.begin_time},
                   {"time", piece.time},
                   {"windows", piece.windows},
                   {"observables", list_json(piece.observables, piece.estimates)}});
  return all;
}

Json stresses_json(std::vector<StressResult> const& stresses) {
  Json all = Json::array();
  for (auto const& one : stresses)
    all.push_back({{"stress", one.stress},
                   {"strain", one.strain},
                   {"windows", one.windows},
                   {"observables", list_json(one.observables, one.estimates)}});
  return all;
}

Json waveform_json(Waveform const& wave) {
  Json all{{"strain", wave.strain}, {"strain_rate", wave.strain_rate}};
  auto const add = [&](std::string const& name, std::vector<statistics::Estimate> const& list) {
    for (auto const& one : list) {
      all[name].push_back(number(one.mean));
      all[name + "_error"].push_back(number(one.error));
    }
  };
  add("sigma", wave.sigma);
  add("p", wave.pressure);
  return all;
}

Json bins_json(std::vector<LoopBin> const& bins) {
  Json all = Json::array();
  for (auto const& bin : bins) {
    Json one{{"strain_rate", bin.strain_rate}, {"windows", bin.windows}};
    one["observables"] = list_json(bin.observables, bin.estimates);
    all.push_back(std::move(one));
  }
  return all;
}

/// Adds results of the protocol other than averages.
void add_protocol(Json& summary, Run const& run) {
  auto const& shear = run.scene.shear;
  if (run.plan.ramp) {
    Loop const loop = loop_of(run);
    summary["loop"] = {{"up", bins_json(loop.up)}, {"down", bins_json(loop.down)}};
    return;
  }
  if (shear.lists_pieces()) {
    summary["pieces"] = pieces_json(piece_results(run));
    return;
  }
  if (shear.oscillates()) {
    auto const cycles = static_cast<std::int64_t>(run.plan.pieces->size());
    summary["oscillation"] = {{"amplitude", shear.amplitude},
                              {"period", oscillation_period(run.scene)},
                              {"cycles", shear.cycles},
                              {"discarded_cycles", run.plan.discarded_windows / cycles},
                              {"waveform", waveform_json(waveform_of(run))}};
    return;
  }
  if (run.plan.stages > 1) {
    summary["stresses"] = stresses_json(stress_results(run));
    return;
  }
  if (!shear.discard)
    summary["steady_state"] = {
        {"method", "MSER-5 of " + fmt::format("{}", fmt::join(settling_names(run), " and "))},
        {"found", run.steady_found},
        {"discarded_windows", run.plan.discarded_windows}};
  for (auto const& [name, error] : run.reached)
    summary["target_error"][name] = {{"wanted", shear.target_error.at(name)},
                                     {"reached", number(error)}};
  if (!run.reached.empty()) summary["target_error_reached"] = run.target_met;
}

/// Warnings, or notes, of all that is said.
Json warnings_json(std::vector<Warning> const& said, bool notes) {
  Json all = Json::array();
  for (auto const& warning : said) {
    if (warning.is_note != notes) continue;
    Json numbers = Json::object();
    for (auto const& [name, value] : warning.numbers) numbers[name] = number(value);
    all.push_back({{"name", warning.name},
                   {"numbers", std::move(numbers)},
                   {"reason", warning.reason},
                   {"remedy", warning.remedy}});
    if (!warning.command.empty()) all.back()["command"] = warning.command;
  }
  return all;
}

/// Each replica's own means and errors.
Json replicas_json(Run const& run, std::vector<NamedEstimate> const& list) {
  Json all = Json::array();
  auto const seed = seeds(run);
  for (std::size_t r = 0; r < seed.size(); ++r) {
    Json one{{"seed", seed[r]}};
    for (auto const& named : list)
      one["observables"][std::string(named.observable.name)] =
          estimate_json(named.estimate.each[r], named.sample_strain);
    all.push_back(std::move(one));
  }
  return all;
}

}  // namespace

void write_summary(RunFolder const& folder, Run const& run, std::vector<NamedEstimate> const& list,
                   std::vector<Warning> const& warnings) {
  Provenance const made = provenance();
  double const total = path_of(run, static_cast<std::size_t>(run.plan.windows));
  double measured = total - path_of(run, discarded(run));
  if (run.plan.stages > 1) {  // a part of each stress
    measured = 0;
    for (auto const& one : stress_results(run)) measured += std::abs(one.strain);
  }
  double const disk_steps = static_cast<double>(run.plan.steps) *
                            static_cast<double>(run.scene.disks.count) *
                            static_cast<double>(run.replicas.size());

  Json summary;
  summary["schema"] = 1;
  summary["bagnold"] = {{"version", made.version}, {"git", made.git}};
  summary["scene"] = scene_json(run.scene);
  summary["strain"] = {{"total", total}, {"measured", measured}};
  summary["steps"] = run.plan.steps;
  summary["wall_seconds"] = run.wall_seconds;
  summary["disk_steps_per_second"] =
      number(run.wall_seconds > 0 ? disk_steps / run.wall_seconds : nan);
  summary["warnings"] = warnings_json(warnings, false);
  summary["notes"] = warnings_json(warnings, true);
  add_protocol(summary, run);
  if (run.bias) summary["bias"] = bias_json(*run.bias);
  bool const several = run.replicas.size() > 1 && !list.empty();
  if (several) summary["errors_from"] = errors_from(run);
  summary["observables"] = Json::object();
  for (auto const& named : list)
    summary["observables"][std::string(named.observable.name)] =
        with_bias(estimate_json(named.estimate.all, named.sample_strain), named.estimate.all,
                  bias_of(run, named.observable.name));
  if (several) summary["replicas"] = replicas_json(run, list);
  io::replace_text(folder.summary(), summary.dump(2) + "\n");
}

}  // namespace bagnold
