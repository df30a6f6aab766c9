// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/contradictions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string_view>
#include <vector>

#include "src/config/abilities.hpp"
#include "src/config/names.hpp"
#include "src/config/quasi_static.hpp"
#include "src/config/shown.hpp"
#include "src/config/time_step.hpp"

namespace bagnold {

namespace {

constexpr std::int64_t most_trajectories = 256;  // systems often allow 1024 open files

/// Adds a mistake of several keys, unless one of them is a mistake already.
struct Refusals {
  std::string const& origin;
  Mistakes& mistakes;

  void operator()(std::vector<std::string_view> const& keys, std::string const& message) const {
    if (std::ranges::none_of(keys, [&](auto const& key) { return mistakes.about(key); }))
      mistakes.add("", fmt::format("{}: {}", origin, message));
  }
};

/// gamma_0 that moves touching disks, d_s apart, by ten thousand roundings of a position in the
/// box: at that G' is right to 0.3%.
double smallest_amplitude(Scene const& scene) {
  return 1e4 * std::numeric_limits<double>::epsilon() / 2 *
         std::max(scene.box_length(), scene.box_height());
}

void look_at_protocol(Scene const& scene, Refusals const& refuse) {
  auto const& shear = scene.shear;
  auto const& rates = shear.strain_rates;
  if (std::ranges::adjacent_find(rates, std::less_equal{}) != rates.end())
    refuse({"shear.strain_rates"},
           fmt::format(
               "shear.strain_rates = [{:g}] (each must be below the one before: it starts from "
               "the state of the next larger); write the largest first, none twice",
               fmt::join(rates, ", ")));
  if (shear.strain.is_list() && shear.strain.each.size() != rates.size())
    refuse({"shear.strain", "shear.strain_rates"},
           fmt::format(
               "shear.strain = [{:g}] has {} numbers, shear.strain_rates has {} (must be as many); "
               "give one for each rate, or one number for all",
               fmt::join(shear.strain.each, ", "), shear.strain.each.size(), rates.size()));
  if (shear.ramps() && shear.strain_rate_high <= shear.strain_rate)
    refuse(
        {"shear.strain_rate_high", "shear.strain_rate"},
        fmt::format(
            "shear.strain_rate_high = {} (must be more than shear.strain_rate = {}, the lowest); "
            "raise it",
            shear.strain_rate_high, shear.strain_rate));
  if (!shear.has_one_flow() && !shear.discard)
    refuse({"shear.discard"},
           fmt::format("shear.discard = \"auto\" (seeks one steady state, which shear.protocol = "
                       "\"{}\"{} has not); give a share",
                       shear.protocol, shear.controlled() ? " with a list of stresses" : ""));
  if (shear.oscillates() && shear.period.has_value() == shear.peak_rate.has_value())
    refuse({"shear.period", "shear.peak_rate"},
           fmt::format("shear.period and shear.peak_rate {} (either makes the other, by "
                       "shear.amplitude = peak_rate period/2 pi); give one of them",
                       shear.period ? "are both given" : "are missing"));
  bool const by_number = shear.inertial_number.has_value();
  if (shear.changes_box() && !by_number && shear.strain_rate == 0)
    refuse({"shear.strain_rate", "shear.inertial_number"},
           "shear.strain_rate and shear.inertial_number are missing (either makes the other, by "
           "I = strain_rate/sqrt(pressure)); give one of them");
  double const by_pressure = shear.inertial_number.value_or(0) * std::sqrt(shear.pressure);
  if (by_number && std::abs(by_pressure - shear.strain_rate) > 1e-9 * by_pressure)
    refuse({"shear.strain_rate", "shear.inertial_number", "shear.pressure"},
           fmt::format("shear.strain_rate = {} (shear.inertial_number = {} and shear.pressure = {} "
                       "make {:.6g}); give one of the two",
                       shear.strain_rate, *shear.inertial_number, shear.pressure, by_pressure));
  if (shear.oscillates() && shear.amplitude < smallest_amplitude(scene))
    refuse({"shear.amplitude", "disks.count", "disks.packing_fraction", "disks.box_aspect"},
           fmt::format(
               "shear.amplitude = {} (is lost in the rounding of positions: in this box {:.2g} "
               "moves touching disks by 10^4 of it); take a larger one",
               shear.amplitude, smallest_amplitude(scene)));
  if (!shear.target_error.empty() &&
      (scene.measure.profiles || scene.measure.fields || scene.measure.rotation))
    refuse(
        {"shear.target_error", "measure.profiles", "measure.fields", "measure.rotation"},
        "shear.target_error does not go with measure.profiles, measure.fields or measure.rotation "
        "(where their frames begin depends on where the run ends); give shear.strain alone");
}

void look_at_trajectories(std::string_view key, double spacing, std::int64_t replicas,
                          Refusals const& refuse) {
  if (spacing > 0 && replicas > most_trajectories)
    refuse({key, "disks.replicas"},
           fmt::format("{0} = {1} with disks.replicas = {2} (must be at most {3}: a file is open "
                       "for each); run some of the seeds at a time, or set {0} = 0",
                       key, spacing, replicas, most_trajectories));
}

void look_at_others(Scene const& scene, Refusals const& refuse) {
  auto const& disks = scene.disks;
  if (disks.count % 2 != 0)
    refuse({"disks.count"},
           fmt::format(
               "disks.count = {} (must be even: half the disks are small, half big); use {} or {}",
               disks.count, disks.count - 1, disks.count + 1));
  if (disks.packing_fraction >= 1)
    refuse({"disks.packing_fraction"},
           "disks.packing_fraction = 1 (must be below 1: disks cannot fill the plane)");
  if (std::ranges::count(force_exponents(), disks.force_exponent) == 0)
    refuse({"disks.force_exponent"}, fmt::format("disks.force_exponent = {} (must be {})",
                                                 disks.force_exponent, exponent_choice()));
  if (std::ranges::count(separate_models(), disks.model) == 0 &&
      (disks.damping_normal != 1 || disks.damping_tangential != 1))
    refuse({"disks.model", "disks.damping_normal", "disks.damping_tangential"},
           fmt::format("disks.damping_normal and disks.damping_tangential belong to model "
                       "{}, not \"{}\"; change disks.model or leave them out",
                       choice(separate_models()), disks.model));
  if (scene.start.kind == "state" && scene.start.file.empty())
    refuse({"start.kind", "start.file"},
           "start.file is missing: start.kind = \"state\" needs a state file");
  if (scene.start.kind == "random" && scene.start.relax)
    refuse({"start.kind", "start.relax"},
           "start.relax = true is for start.kind = \"state\" (a random start is always relaxed); "
           "leave it out");
  if (scene.start.kind == "random" && scene.start.copies)
    refuse(
        {"start.kind", "start.copies"},
        "start.copies = true is for start.kind = \"state\" (a random start has nothing to copy); "
        "leave it out");
  if (scene.start.kind == "random" && !scene.start.file.empty())
    refuse({"start.kind", "start.file"},
           fmt::format("start.file = \"{}\" is not used by start.kind = \"random\"; set "
                       "start.kind = \"state\" or leave it out",
                       shown(scene.start.file)));
  if (scene.shear.discard && *scene.shear.discard >= 1)
    refuse({"shear.discard"}, "shear.discard = 1 (must be below 1) would leave nothing to measure");
  look_at_trajectories("output.trajectory_strain", scene.output.trajectory_strain, disks.replicas,
                       refuse);
  look_at_trajectories("output.trajectory_time", scene.output.trajectory_time, disks.replicas,
                       refuse);
  look_at_trajectories("output.trajectory_decades", scene.output.trajectory_decades, disks.replicas,
                       refuse);
  if (scene.measure.correlations && !scene.measure.contacts)
    refuse({"measure.correlations", "measure.contacts"},
           "measure.correlations = true (looks at contacts, which are not followed); set "
           "measure.contacts = true, or measure.correlations = false");
  if (scene.measure.clusters && !scene.measure.correlations)
    refuse({"measure.clusters", "measure.correlations"},
           "measure.clusters = true (sorts velocities in contact, which are not measured); set "
           "measure.correlations = true, or measure.clusters = false");
  bool const trajectory = scene.output.trajectory_strain > 0 || scene.output.trajectory_decades > 0;
  if (scene.measure.contact_frames && !(scene.measure.contacts && trajectory))
    refuse(
        {"measure.contact_frames", "measure.contacts", "output.trajectory_strain",
         "output.trajectory_decades"},
        fmt::format("measure.contact_frames = true (needs the frames of a trajectory, and "
                    "contacts that are followed for their ages); set measure.contacts = true and "
                    "output.trajectory_{}, or measure.contact_frames = false",
                    scene.shear.ramps() ? "decades" : "strain"));
  if (scene.measure.rotation && !scene.rotates())
    refuse({"measure.rotation", "disks.model"},
           fmt::format("measure.rotation = true (disks of model \"{}\" do not rotate); use model "
                       "{}, or measure.rotation = false",
                       disks.model, choice(rotating_models())));
}

void look_at_drive(Scene const& scene, Refusals const& refuse) {
  auto const& drive = scene.drive;
  if (!scene.driven() && (drive.drag != 0 || drive.temperature != 0))
    refuse(
        {"drive.kind", "drive.drag", "drive.temperature"},
        fmt::format("drive.drag and drive.temperature are not used by drive.kind = \"{}\"; leave "
                    "them out or set drive.kind = {}",
                    drive.kind, choice(acting_drives())));
  if (!scene.driven()) return;
  if (drive.drag == 0)
    refuse({"drive.kind", "drive.drag"},
           fmt::format("drive.drag = 0 (drive.kind = \"{}\" needs one above 0); give it, or set "
                       "drive.kind = \"none\"",
                       drive.kind));
  bool const thermal = std::ranges::count(thermal_drives(), drive.kind) > 0;
  if (thermal && drive.temperature == 0)
    refuse({"drive.kind", "drive.temperature"},
           fmt::format("drive.temperature = 0 (drive.kind = \"{}\" needs one above 0); give it, or "
                       "set another drive.kind",
                       drive.kind));
  if (!thermal && drive.temperature != 0)
    refuse({"drive.kind", "drive.temperature"},
           fmt::format("drive.temperature is not used by drive.kind = \"{}\"; leave it out or set "
                       "drive.kind = {}",
                       drive.kind, choice(thermal_drives())));
}

/// Refuses drives beside an implicit scheme, whose equation has none.
void look_at_scheme(Scene const& scene, Refusals const& refuse) {
  auto const& scheme = scene.integration.scheme;
  if (is_implicit(scheme) && scene.driven())
    refuse({"integration.scheme", "drive.kind"},
           fmt::format("drive.kind = \"{}\" (is not a part of what integration.scheme = \"{}\" "
                       "solves); set integration.scheme = \"auto\"",
                       scene.drive.kind, scheme));
}

/// Refuses pairs of stretches where noise parts them.
void look_at_bias(Scene const& scene, Refusals const& refuse) {
  if (!scene.measure.bias) return;
  if (std::ranges::count(thermal_drives(), scene.drive.kind) > 0)
    refuse({"measure.bias", "drive.kind"},
           fmt::format("measure.bias = true (the noise of drive.kind = \"{}\" differs between two "
                       "time steps, so pairs of stretches show nothing); set measure.bias = false",
                       scene.drive.kind));
}

void look_at_engine(Scene const& scene, Refusals const& refuse) {
  for (auto const& [keys, message] : why_not(scene)) refuse(keys, message);
  for (auto const& [keys, message] : misused_quasi_static(scene)) refuse(keys, message);
}

}  // namespace

void find_contradictions(Scene const& scene, std::string const& origin, Mistakes& mistakes) {
  Refusals const refuse{origin, mistakes};
  look_at_others(scene, refuse);
  look_at_drive(scene, refuse);
  look_at_scheme(scene, refuse);
  look_at_engine(scene, refuse);
  if (!mistakes.about("disks.model")) look_at_bias(scene, refuse);
  if (!mistakes.about("shear.protocol")) look_at_protocol(scene, refuse);
}

}  // namespace bagnold
