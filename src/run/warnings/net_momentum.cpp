// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "kernels/physics/species.hpp"
#include "src/config/strain_rates.hpp"
#include "src/run/warnings/checks.hpp"
#include "src/start/start.hpp"

namespace bagnold {

namespace {

/// Largest share of the mean motion that is not by chance. A drive acts on each disk by itself. In
/// a bath the mean motion has 1/N of the kinetic energy, on average, and ten times that with a
/// probability of e^-10.
double most_share(Scene const& scene) {
  constexpr double most = 0.01, many = 10;
  return scene.driven() ? std::max(most, many / static_cast<double>(scene.disks.count)) : most;
}

/// Share of the mean motion in sum m dv^2 of one replica during the measurement. As u_x changes by
/// -u_y in a unit of strain, and u_y not at all, the mean of u^2 over a strain gamma is
///
///     u_x^2 + u_x u_y gamma + u_y^2 gamma^2/3 + u_y^2,    u at its end,
///
/// and sum m dv^2 = 2 p_kin L_x L_y. For a ramp sum m dv^2 is that at its end. With a drive, which
/// changes u, the mean of u^2 is taken as its value at the end.
double share_of(MeanMotion const& at_end, FinishedRun const& finished) {
  double const kinetic = 2 * finished.mean("p_kin") * finished.box_area();
  if (!(kinetic > 0)) return at_end.share;
  auto const& disks = finished.run.scene.disks;
  bool const by_area = finished.run.scene.mass_by_area();
  double const mass = static_cast<double>(disks.count) *
                      (disk_mass(by_area, small_diameter) + disk_mass(by_area, big_diameter)) / 2;
  auto const [x, y] = at_end.velocity;
  double const strain = finished.run.scene.driven() ? 0 : finished.measured_strain();
  return mass * (x * x + x * y * strain + y * y * (strain * strain / 3 + 1)) / kinetic;
}

Warning taken_off(std::map<std::string, double> const& record) {
  std::array<double, 2> const velocity{record.at(start_mean_velocity_x),
                                       record.at(start_mean_velocity_y)};
  double const share = record.at(start_mean_motion_share);
  return {"net_momentum",
          {{start_mean_velocity_x, velocity[0]},
           {start_mean_velocity_y, velocity[1]},
           {start_mean_motion_share, share}},
          mean_motion_in_words(velocity, share) +
              ", was taken off the state at the start: no force changes it, so p_kin would have "
              "kept it",
          "nothing is to be done where the state was made by another program, or from rest",
          "",
          /*is_note=*/true};
}

}  // namespace

std::string mean_motion_in_words(std::array<double, 2> const& velocity, double share) {
  return fmt::format(
      "the mean motion against the shear flow, ({:.3g}, {:.3g}) d_s/tau_e, {:.2g}% of the kinetic "
      "energy",
      velocity[0], velocity[1], 100 * share);
}

std::optional<Warning> net_momentum(FinishedRun const& finished) {
  auto const& replicas = finished.run.replicas;
  double share = 0;
  MeanMotion motion{};
  for (auto const& replica : replicas)
    if (replica.end_motion &&
        is_more_than_rounding(*replica.end_motion, typical_rate(finished.run.scene),
                              finished.run.box_height()) &&
        share_of(*replica.end_motion, finished) > share) {
      motion = *replica.end_motion;
      share = share_of(motion, finished);
    }
  if (share > most_share(finished.run.scene))
    return Warning{"net_momentum",
                   {{"share", share},
                    {"mean_velocity_x", motion.velocity[0]},
                    {"mean_velocity_y", motion.velocity[1]}},
                   mean_motion_in_words(motion.velocity, share) +
                       ", is counted in p_kin, T_g and R_v: contacts do not change it",
                   "start again from the last state, of which it is taken off",
                   "bagnold run DIR/scene.toml --set start.kind=state --set start.file=state.h5 "
                   "--out DIR-start"};
  auto const most = std::ranges::max_element(replicas, {}, [](Replica const& replica) {
    auto const found = replica.start_record.find(start_mean_motion_share);
    return found == replica.start_record.end() ? 0.0 : found->second;
  });
  if (most != replicas.end() && most->start_record.contains(start_mean_motion_share))
    return taken_off(most->start_record);
  return {};
}

}  // namespace bagnold
