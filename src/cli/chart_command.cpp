// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>

#include "src/analysis/csv.hpp"
#include "src/analysis/panel.hpp"
#include "src/analysis/report.hpp"
#include "src/cli/exit_code.hpp"
#include "src/cli/options.hpp"
#include "src/cli/signals.hpp"
#include "src/cli/standard_streams.hpp"
#include "src/config/cascade.hpp"
#include "src/config/errors.hpp"
#include "src/config/names.hpp"
#include "src/config/scene_file.hpp"
#include "src/config/time_step.hpp"
#include "src/io/atomic_file.hpp"
#include "src/run/bias/chart.hpp"
#include "src/run/messages.hpp"
#include "src/run/plot.hpp"
#include "src/run/rounded.hpp"
#include "src/run/start_or_resume.hpp"
#include "src/run/validate_scene.hpp"
#include "src/start/start.hpp"

namespace bagnold {

namespace {

namespace fs = std::filesystem;

struct ChartOptions {
  SceneOptions scene;
  double strain = 0.5, apart = 0.1;
  int states = 6;
};

constexpr auto q_of = [](std::size_t q) { return std::string(bias::quantity_names[q]); };

bool is_judged(bias::ChartedMethod const& one) { return !one.failed && one.seconds > 0; }

/// Largest |b| of p, sigma and Z, and its error.
std::pair<double, double> worst(bias::ChartedMethod const& one) {
  std::pair<double, double> most{0, 0};
  for (auto const q : {bias::pressure, bias::shear_stress, bias::contact_number}) {
    auto const& b = one.judgement.stated[q];
    if (std::abs(b.value) >= most.first) most = {std::abs(b.value), b.error};
  }
  return most;
}

std::string verdict_of(bias::ChartedMethod const& one) {
  if (one.failed) return "a step failed";
  if (!is_judged(one)) return "not known";
  auto const verdict = one.judgement.verdict;
  return std::string(bias::name_of(verdict == bias::Verdict::none ? bias::Verdict::open : verdict));
}

/// The cheapest method that is accepted; null: none is.
bias::ChartedMethod const* best_of(bias::Chart const& chart) {
  bias::ChartedMethod const* best = nullptr;
  for (auto const& one : chart.methods)
    if (is_judged(one) && one.judgement.verdict == bias::Verdict::accepted &&
        (!best || one.seconds < best->seconds))
      best = &one;
  return best;
}

analysis::Rows table_of(bias::Chart const& chart) {
  analysis::Rows rows;
  rows.columns = {"scheme", "time_step", "disk_steps", "seconds", "seconds_error"};
  for (std::size_t q = 0; q < bias::quantities; ++q)
    for (auto const* end : {"_bias", "_bias_error"}) rows.columns.push_back(q_of(q) + end);
  rows.columns.emplace_back("verdict");
  for (auto const& one : chart.methods) {
    std::vector<std::string> row{one.scene.integration.scheme, analysis::cell(one.time_step),
                                 analysis::cell(one.disk_steps)};
    bool const known = is_judged(one);
    auto const add = [&](double value) { row.push_back(known ? analysis::cell(value) : ""); };
    add(one.seconds);
    add(one.seconds_error);
    for (std::size_t q = 0; q < bias::quantities; ++q) {
      add(one.judgement.stated[q].value);
      add(one.judgement.stated[q].error);
    }
    row.push_back(verdict_of(one));
    rows.rows.push_back(std::move(row));
  }
  return rows;
}

/// |b| of p, sigma and Z against seconds, a curve a scheme.
analysis::Report picture_of(bias::Chart const& chart) {
  analysis::Report report;
  analysis::Panel panel(report, "seconds of CPU a unit of strain", "largest bias of p, sigma, Z",
                        true, true);
  for (auto const& one : chart.methods) {
    if (!is_judged(one)) continue;
    auto const [b, error] = worst(one);
    panel.point("data", one.scene.integration.scheme, one.seconds, one.seconds_error,
                std::max(b, 1e-5), error);
  }
  return report;
}

void print(bias::Chart const& chart, Scene const& scene) {
  fmt::print("\n{:<26} {:>9} {:>12} {:>11}  {:<12} {:<12} {:<12} {:<12} {}\n", "scheme",
             "time_step", "disk-steps", "seconds", "p %", "sigma %", "Z %", "T_g %",
             fmt::format("within {:g}%", 100 * scene.integration.accuracy));
  for (auto const& one : chart.methods) {
    fmt::print("{:<26} {:>9.5g} {:>12.3g} ", one.scene.integration.scheme, one.time_step,
               one.disk_steps);
    if (is_judged(one)) {
      fmt::print("{:>11.3g}  ", one.seconds);
      for (std::size_t q = 0; q <= bias::temperature; ++q)
        fmt::print("{:<12} ",
                   rounded_bias(one.judgement.stated[q].value, one.judgement.stated[q].error));
    } else {
      fmt::print("{:>11}  {:<12} {:<12} {:<12} {:<12} ", "-", "-", "-", "-", "-");
    }
    fmt::print("{}\n", verdict_of(one));
  }
  fmt::print(
      "\ndisk-steps and seconds of CPU (one thread) are of a unit of strain; biases are beside {} "
      "at "
      "{:.4g}, from {} states, over a strain of {:.3g}\n",
      chart.finest.integration.scheme, time_step(chart.finest), chart.states, chart.strain);
  if (auto const* best = best_of(chart))
    fmt::print(
        "the cheapest within {:g}%: --set integration.scheme={} --set "
        "integration.time_step={:.6g}\n",
        100 * scene.integration.accuracy, best->scene.integration.scheme, best->time_step);
  else
    fmt::print("none is known to be within {:g}%: more --states tell more\n",
               100 * scene.integration.accuracy);
}

/// The scene at one rate: of a cascade its last.
Scene steady(Scene const& scene) {
  if (scene.shear.run_per_rate()) {
    Scene one = runs_of(scene).back();
    one.start = scene.start;
    return one;
  }
  if (scene.shear.rate_stays()) return scene;
  throw InputError(
      fmt::format("shear.protocol = \"{}\" (has no one rate at which methods can be "
                  "compared); chart the scene with --set shear.protocol=steady",
                  scene.shear.protocol));
}

/// The start of the first replica. scene: with all of them, as a file has a state for each.
State start_of(Scene const& scene) {
  auto from_file = states_in_file(scene);
  if (from_file.empty()) return random_start(scene).state;
  if (scene.start.relax) relax_state(from_file.front(), scene);
  return std::move(from_file.front().state);
}

/// Shows what is done, twice a second.
class Shown {
 public:
  explicit Shown(bool quiet) : quiet_(quiet), terminal_(isatty(STDOUT_FILENO) == 1) {}

  bool operator()(double share, std::string const& what) {
    auto const now = std::chrono::steady_clock::now();
    auto const pause = std::chrono::milliseconds(terminal_ ? 500 : 30000);
    if (!quiet_ && now - shown_ > pause) {
      shown_ = now;
      auto const line = fmt::format("{:3.0f}%  {}", 100 * share, what);
      put(terminal_ ? fmt::format("\r{:<78}", line) : line + "\n");
    }
    return stop_signal() == 0;
  }

  void end() const {
    if (!quiet_ && terminal_) put("\n");
  }

 private:
  bool quiet_, terminal_;
  std::chrono::steady_clock::time_point shown_{};
};

int chart_command(ChartOptions const& options) {
  Scene const given = steady(read_scene(options.scene));
  Scene scene = given;
  scene.disks.replicas = 1;
  scene.measure = {.every = scene.measure.every};
  Scene judged = scene;
  judged.measure.bias = true;  // a chart judges all methods by the accuracy
  validated_plan(judged, options.scene.allow_unstable);
  if (scene.driven() && std::ranges::count(thermal_drives(), scene.drive.kind) > 0)
    throw InputError(
        fmt::format("drive.kind = \"{}\" (its noise parts two methods at once, so that "
                    "pairs of stretches show nothing); chart the scene without it",
                    scene.drive.kind));
  auto const folder =
      options.scene.folder.empty()
          ? fs::path("results") / (options.scene.scene_file.stem().string() + "-chart")
          : options.scene.folder;
  catch_signals();
  KokkosScope const kokkos({"serial", 1}, scene);
  fs::create_directories(folder);
  Shown shown(options.scene.quiet);
  auto const chart = bias::chart(scene, start_of(given),
                                 {.warm_up = options.strain,
                                  .states = static_cast<std::size_t>(options.states),
                                  .apart = options.apart,
                                  .go_on = std::ref(shown)});
  shown.end();
  if (int const signal = stop_signal(); signal != 0) {
    say(
        fmt::format("stopped after {} of {} states; a chart keeps no checkpoint, the same command "
                    "begins anew",
                    chart.states, options.states));
    if (chart.states < 2) return 128 + signal;
  }
  io::replace_text(folder / "chart.csv", analysis::to_csv(table_of(chart)));
  auto const drawn = folder / "chart.drawn.csv";
  io::replace_text(drawn, analysis::to_csv(picture_of(chart).drawn));
  if (!options.scene.quiet) print(chart, scene);
  if (auto const wrong = draw_plot(drawn, folder / "chart.png"); !wrong.empty()) warn(wrong);
  if (!options.scene.quiet) fmt::print("\nresults in {}\n", folder.string());
  return stop_signal() == 0 ? done : 128 + stop_signal();
}

}  // namespace

Command add_chart(Words program) {
  auto const options = std::make_shared<ChartOptions>();
  Words command = add_command(
      program, "chart",
      "bias against seconds of all schemes and steps that can do the scene, from common states");
  add_scene_options(command, options->scene);
  command.option("--out", options->scene.folder,
                 "folder for chart.csv and chart.png [results/SCENE-chart]");
  command.option("--strain", options->strain, "strain before the first state [0.5]")
      .between(0.0, 1000.0);
  command.option("--states", options->states, "states from which all step [6]").between(2, 1000);
  command.option("--apart", options->apart, "strain between them [0.1]").between(1e-3, 100.0);
  command.flag("--quiet", options->scene.quiet, "print nothing");
  return {command, [options] { return chart_command(*options); }};
}

}  // namespace bagnold
