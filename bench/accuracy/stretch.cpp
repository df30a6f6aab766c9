// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "bench/accuracy/commands.hpp"
#include "bench/accuracy/start.hpp"

namespace bagnold::accuracy {

namespace {

/// Short stretches from common starts, each scheme against one with a very small step: what the
/// trajectories have in common drops out of the difference of their means, and so does most noise.
struct Stretches {
  Start start;
  std::string guide = "two-stage:0.1";  ///< goes from start to start
  std::string reference = "modified-velocity-verlet:0.003125";
  std::vector<std::string> methods;
  double length = 0.02, settle = 0.2, discard = 1, between = 0.05;
  int starts = 8;
};

struct Outcome {
  Sample mean;
  State end;
};

constexpr char const* shown_quantities[] = {"p", "p_el", "sigma", "Z", "T_g", "dissipation"};

double value_of(Sample const& sample, int quantity) {
  auto const& a = sample.value;
  using C = SumColumns;
  switch (quantity) {
    case 0:
      return a[C::elastic_xx] + a[C::elastic_yy] + a[C::dissipative_xx] + a[C::dissipative_yy] +
             a[C::kinetic_xx] + a[C::kinetic_yy];
    case 1:
      return a[C::elastic_xx] + a[C::elastic_yy];
    case 2:
      return -(a[C::elastic_xy] + a[C::dissipative_xy] + a[C::kinetic_xy]);
    case 3:
      return a[C::contacts];
    case 4:
      return a[C::kinetic_xx] + a[C::kinetic_yy];
    default:
      return a[Sample::dissipated];
  }
}

Outcome stretch(Stretches const& o, State const& from, Method const& method) {
  auto const system = make_system(o.start.scene, from, method, true);
  auto const steps = std::llround(o.length / (o.start.scene.shear.strain_rate * method.time_step));
  auto const settled = std::llround(o.settle * static_cast<double>(steps));
  Outcome outcome;
  for (long long k = 0; k < steps; ++k) system->step(k < settled ? nullptr : &outcome.mean);
  for (double& v : outcome.mean.value) v /= static_cast<double>(steps - settled);
  outcome.end = system->state();
  return outcome;
}

/// Root mean square distance of the disks of two states, nearest images, [d_s].
double distance(State const& a, State const& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.count(); ++i) {
    double x = a.position[i][0] - b.position[i][0], y = a.position[i][1] - b.position[i][1];
    double const n = std::round(y / a.box_height());
    y -= n * a.box_height();
    x -= n * a.offset;
    x -= std::round(x / a.box_length) * a.box_length;
    sum += x * x + y * y;
  }
  return std::sqrt(sum / static_cast<double>(a.count()));
}

struct Differences {
  std::vector<double> of[std::size(shown_quantities)];
  double distance = 0;
  std::string failed;
};

std::pair<double, double> mean_and_error(std::vector<double> const& values) {
  double const n = static_cast<double>(values.size());
  double mean = 0, square = 0;
  for (double v : values) mean += v / n;
  for (double v : values) square += (v - mean) * (v - mean);
  return {mean, std::sqrt(square / (n * (n - 1)))};
}

void run(Stretches& o) {
  State const state = o.start.read();
  auto const& scene = o.start.scene;
  Method const guide = read_method(o.guide), reference = read_method(o.reference);
  std::vector<Method> methods;
  for (auto const& text : o.methods) methods.push_back(read_method(text));
  std::vector<Differences> differences(methods.size());
  std::vector<double> scale(std::size(shown_quantities), 0.0);

  auto const main = make_system(scene, state, guide);
  for (int n = 0; n < o.starts; ++n) {
    double const strain = n == 0 ? o.discard : o.between;
    auto const steps = std::llround(strain / (scene.shear.strain_rate * guide.time_step));
    for (long long k = 0; k < steps; ++k) main->step(nullptr);
    State const from = main->state();
    Outcome const exact = stretch(o, from, reference);
    for (std::size_t q = 0; q < scale.size(); ++q)
      scale[q] += value_of(exact.mean, static_cast<int>(q)) / o.starts;
    for (std::size_t m = 0; m < methods.size(); ++m) try {
        Outcome const outcome = stretch(o, from, methods[m]);
        for (std::size_t q = 0; q < scale.size(); ++q)
          differences[m].of[q].push_back(value_of(outcome.mean, static_cast<int>(q)) -
                                         value_of(exact.mean, static_cast<int>(q)));
        differences[m].distance += distance(outcome.end, exact.end) / o.starts;
      } catch (NumericalError const& error) {
        differences[m].failed = error.what();
      }
  }

  fmt::print("{},{},stretch,starts", scene_header, method_header);
  for (auto const* name : shown_quantities) fmt::print(",{},{}_error", name, name);
  fmt::print(",distance,status\n");
  for (std::size_t m = 0; m < methods.size(); ++m) {
    fmt::print("{},{},{},{}", scene_columns(scene), method_columns(methods[m]), o.length, o.starts);
    auto const& d = differences[m];
    for (std::size_t q = 0; q < scale.size(); ++q) {
      if (!d.failed.empty()) {
        fmt::print(",,");
        continue;
      }
      auto const [mean, error] = mean_and_error(d.of[q]);
      fmt::print(",{:.3g},{:.2g}", mean / scale[q], error / scale[q]);
    }
    if (d.failed.empty())
      fmt::print(",{:.3g},ok\n", d.distance);
    else
      fmt::print(",,{}\n", d.failed);
  }
}

}  // namespace

void add_stretch(CLI::App& app) {
  auto* const command = app.add_subcommand(
      "stretch", "relative differences of means over short stretches from common starts");
  auto const o = std::make_shared<Stretches>();
  o->start.add_options(*command);
  command->add_option("--methods", o->methods, "SCHEME:DT ...")->required()->delimiter(',');
  command->add_option("--reference", o->reference, "SCHEME:DT")->capture_default_str();
  command->add_option("--guide", o->guide, "SCHEME:DT between starts")->capture_default_str();
  command->add_option("--length", o->length, "strain of a stretch")->capture_default_str();
  command->add_option("--settle", o->settle, "share of it not measured")->capture_default_str();
  command->add_option("--discard", o->discard, "strain before the first")->capture_default_str();
  command->add_option("--between", o->between, "strain between starts")->capture_default_str();
  command->add_option("--starts", o->starts)->check(CLI::Range(2, 10000))->capture_default_str();
  command->callback([o] { run(*o); });
}

}  // namespace bagnold::accuracy
