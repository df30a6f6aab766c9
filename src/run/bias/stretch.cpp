// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/bias/stretch.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "kernels/physics/schemes/schemes.hpp"
#include "src/config/schemes.hpp"
#include "src/config/time_step.hpp"
#include "src/engine/make_simulation.hpp"
#include "src/measure/observables.hpp"

namespace bagnold::bias {

namespace {

/// before, counted: means over the first third of a stretch, and over the others.
Averages averages_from(Scene const& scene, double box_length, std::vector<double> const& before,
                       std::vector<double> const& counted) {
  auto const list = observables(scene, box_length);
  auto const value = [&](std::string_view name, std::vector<double> const& of) {
    return std::ranges::find(list, name, &Observable::name)->value(of);
  };
  return {.p = value("p", counted),
          .sigma = value("sigma", counted),
          .contact_number = value("Z", counted),
          .temperature = value("T_g", counted),
          .kinetic_pressure = value("p_kin", counted),
          .temperature_before = value("T_g", before)};
}

/// Time by which velocities lag behind the positions of a state, [tau_e]: leapfrogs have them half
/// a step before.
double lag(Scene const& scene) {
  auto const scheme = scheme_of(scene);
  return scheme == default_scheme || scheme == ImplicitDamping::name ? time_step(scene) / 2 : 0;
}

}  // namespace

State handed_over(State start, Scene const& from, Scene const& to, std::string const& backend) {
  double const share = (lag(from) - lag(to)) / time_step(from);
  if (!(share > 0)) return start;
  auto const one = make_simulation(from, first_snapshot(start), backend);
  OpenWindows unused;
  one->advance(1, {.last_step = 1}, unused);
  State const next = one->state();
  double const dt = time_step(from), height = start.box_height();
  for (std::size_t i = 0; i < start.count(); ++i) {
    auto& v = start.velocity[i];
    auto w = next.velocity[i];  // less the flow of the boxes that it rose by
    w[0] += std::round((start.position[i][1] + dt * w[1] - next.position[i][1]) / height) *
            from.shear.strain_rate * height;
    for (int axis : {0, 1}) v[axis] += share * (w[axis] - v[axis]);
    if (!start.spin.empty()) start.spin[i] += share * (next.spin[i] - start.spin[i]);
  }
  return start;
}

Stretch::Stretch(Scene const& scene, State const& start, std::string const& backend,
                 std::int64_t third, std::int64_t every)
    : scene_(scene),
      box_length_(start.box_length),
      simulation_(make_simulation(scene, first_snapshot(start), backend)),
      sampling_{.window_steps = third * every, .every = every, .last_step = 3 * third * every} {}

bool Stretch::advance(std::function<bool()> const& go_on) {
  return size_.step(*simulation_, sampling_, thirds_, go_on);
}

Averages Stretch::averages() const { return averages_of(scene_, box_length_, thirds_); }

Averages averages_of(Scene const& scene, double box_length, OpenWindows const& windows,
                     std::size_t stride) {
  auto const mean = [&](std::size_t first, std::size_t end) {
    std::vector<double> sums(windows.sums[first].sums.size(), 0.0);
    double weight = 0;
    for (auto w = first; w < end; w += stride) {
      for (std::size_t c = 0; c < sums.size(); ++c) sums[c] += windows.sums[w].sums[c];
      weight += windows.sums[w].weight;
    }
    for (double& sum : sums) sum /= weight;
    return sums;
  };
  auto const count = windows.sums.size();
  return averages_from(scene, box_length, mean(0, count / 3), mean(count / 3, count));
}

Averages averages_of(Scene const& scene, double box_length, statistics::Windows const& windows,
                     std::size_t first, std::size_t last) {
  auto const third = first + (last - first) / 3;
  return averages_from(scene, box_length, windows.mean(first, third), windows.mean(third, last));
}

}  // namespace bagnold::bias
