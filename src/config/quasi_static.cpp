// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/quasi_static.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace bagnold {

namespace {

constexpr double steps_per_strain = 1000, longest_step_strain = 1e-2;
constexpr std::int64_t most_disks = 4096;
constexpr double fastest = 1e-5;  ///< [1/tau_e]

double fastest_rate(Scene::Shear const& shear) {
  if (!shear.run_per_rate()) return shear.strain_rate;
  return shear.strain_rates.empty() ? 0 : std::ranges::max(shear.strain_rates);
}

std::string because(std::string const& why, std::string const& remedy) {
  return fmt::format("integration.engine = \"{}\" ({}); {}", quasi_static_engine, why, remedy);
}

std::vector<Refusal> long_step(Scene::Integration const& integration) {
  if (!(integration.time_step.number > longest_explicit_step)) return {};
  return {{{"integration.time_step", "integration.engine"},
           fmt::format("integration.time_step = {:g} (must be at most {:g} but with "
                       "integration.engine = \"{}\"); set \"auto\"",
                       *integration.time_step.number, longest_explicit_step, quasi_static_engine)}};
}

}  // namespace

bool is_quasi_static(Scene const& scene) { return scene.integration.engine == quasi_static_engine; }

double quasi_static_time_step(Scene const& scene) {
  return 1 / (steps_per_strain * scene.shear.strain_rate);
}

std::vector<Refusal> misused_quasi_static(Scene const& scene) {
  if (!is_quasi_static(scene)) return long_step(scene.integration);
  std::vector<Refusal> list;
  auto const& shear = scene.shear;
  double const rate = fastest_rate(shear);
  if (scene.disks.count > most_disks)
    list.push_back(
        {{"integration.engine", "disks.count"},
         because(fmt::format("factorizes a matrix of all disks, which grows as N^1.75: above {} it "
                             "gains little, disks.count = {}",
                             most_disks, scene.disks.count),
                 "set integration.scheme = \"implicit-damping\" and integration.engine = "
                 "\"auto\"")});
  if (rate > fastest * (1 + 1e-9))
    list.push_back(
        {{"integration.engine", "shear.strain_rate", "shear.strain_rates"},
         because(fmt::format("is for flows that creep, up to a rate of {:g}: at {:g} other steps "
                             "cost less, and inertia has a part",
                             fastest, rate),
                 "set integration.engine = \"auto\"")});
  if (auto const step = scene.integration.time_step.number;
      step && *step * rate > longest_step_strain * (1 + 1e-9))
    list.push_back(
        {{"integration.engine", "integration.time_step", "shear.strain_rate"},
         because(fmt::format("integration.time_step = {:g} is a strain of {:.3g}, above {:g} "
                             "stresses are wrong by a tenth",
                             *step, *step * rate, longest_step_strain),
                 fmt::format("set \"auto\", a strain of {:g}", 1 / steps_per_strain))});
  return list;
}

}  // namespace bagnold
