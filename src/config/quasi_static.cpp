// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/quasi_static.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "kernels/physics/repulsion/repulsion.hpp"
#include "src/config/engine_refusals.hpp"

namespace bagnold {

namespace {

constexpr double steps_per_strain = 1000, longest_step_strain = 1e-2;
constexpr std::int64_t most_disks = 4096;
constexpr double fastest = 1e-5;  ///< [1/tau_e]

double fastest_rate(Scene::Shear const& shear) {
  if (shear.protocol != "cascade") return shear.strain_rate;
  return shear.strain_rates.empty() ? 0 : std::ranges::max(shear.strain_rates);
}

std::string because(std::string const& why, std::string const& remedy) {
  return EngineRefusals::because(quasi_static_engine, why, remedy);
}

std::vector<Refusal> of_another_engine(Scene const& scene) {
  std::vector<Refusal> list;
  auto const& integration = scene.integration;
  if (integration.scheme == backward_euler)
    list.push_back({{"integration.scheme", "integration.engine"},
                    fmt::format("integration.scheme = \"{}\" (is stepped by integration.engine = "
                                "\"{}\" alone, here it is \"{}\"); set that engine, or "
                                "integration.scheme = \"auto\"",
                                backward_euler, quasi_static_engine, integration.engine)});
  if (integration.time_step.number > longest_explicit_step)
    list.push_back(
        {{"integration.time_step", "integration.engine"},
         fmt::format("integration.time_step = {:g} (must be at most {:g} but with "
                     "integration.engine = \"{}\"); set \"auto\"",
                     *integration.time_step.number, longest_explicit_step, quasi_static_engine)});
  return list;
}

}  // namespace

bool is_quasi_static(Scene const& scene) { return scene.integration.engine == quasi_static_engine; }

double quasi_static_time_step(Scene const& scene) {
  return 1 / (steps_per_strain * scene.shear.strain_rate);
}

std::vector<Refusal> not_quasi_static(Scene const& scene) {
  if (!is_quasi_static(scene)) return {};
  EngineRefusals refuse(quasi_static_engine);
  std::string const other = "set integration.engine = \"auto\"";
  auto const& scheme = scene.integration.scheme;
  if (scheme != automatic && scheme != backward_euler)
    refuse({"integration.scheme"},
           fmt::format("steps with \"{}\", not with integration.scheme = \"{}\"", backward_euler,
                       scheme),
           "set integration.scheme = \"auto\", or another engine");
  if (scene.driven())
    refuse({"drive.kind"},
           fmt::format("has no part for drive.kind = \"{}\" in its equations", scene.drive.kind),
           other);
  if (scene.disks.force_exponent != HarmonicRepulsion::force_exponent)
    refuse({"disks.force_exponent"},
           fmt::format("was measured with {} repulsion alone, disks.force_exponent = {}, here it "
                       "is {}",
                       HarmonicRepulsion::name, HarmonicRepulsion::force_exponent,
                       scene.disks.force_exponent),
           other);
  refuse.unless_linear(scene, other);
  if (scene.shear.protocol == "ramp")
    refuse({"shear.protocol"}, "steps by strain, where shear.protocol = \"ramp\" goes by time",
           other);
  if (scene.measure.contacts)
    refuse({"measure.contacts"}, "does not see contacts that begin and end within a step",
           "set measure.contacts = false, or integration.engine = \"auto\"");
  if (scene.measure.profiles)
    refuse({"measure.profiles"}, "has no stresses of single disks",
           "set measure.profiles = false, or integration.engine = \"auto\"");
  return refuse.take();
}

std::vector<Refusal> misused_quasi_static(Scene const& scene) {
  if (!is_quasi_static(scene)) return of_another_engine(scene);
  std::vector<Refusal> list;
  auto const& shear = scene.shear;
  double const rate = fastest_rate(shear);
  if (scene.disks.count > most_disks)
    list.push_back(
        {{"integration.engine", "disks.count"},
         because(fmt::format("factorizes a matrix of all disks, which grows as N^1.5: above {} it "
                             "gains nothing, disks.count = {}",
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
  if (scene.integration.time_step.word == of_papers)
    list.push_back({{"integration.engine", "integration.time_step"},
                    because("has steps of a strain, integration.time_step = \"paper\" is that of "
                            "another scheme",
                            "set \"auto\"")});
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
