// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kernels/physics/species.hpp"
#include "src/run/warnings/checks.hpp"

namespace bagnold {

namespace {

constexpr double most_anisotropy = 2;  ///< R_v of a homogeneous flow is about 1, P2 Fig. 24

/// Root mean square of the excess motion along the flow over gammadot L_y from which on bands
/// explain it. Two adjacent bands of rates 0 and gammadot/f, of which the fast one has the share f,
/// make a triangle of v_x - gammadot y with (1 - f)/12^(1/2) of it: 0.14 for f = 1/2. Homogeneous
/// flow has some gammadot d_s in any box: CD at phi = 0.60, R_v = 3 to 4, has 0.077 at N = 256 and
/// 0.023 at 4096.
constexpr double least_of_bands = 0.1;
constexpr double least_length = 12;    ///< [d_s]: about 100 disks
constexpr double worth_a_word = 0.01;  ///< p_kin / p, as large as the biases of time steps

/// p_kin uses velocities relative to gammadot y, P2 Eq. 14 those relative to the average profile.
std::string flow_of_bands(double kinetic_share) {
  if (!(kinetic_share > worth_a_word)) return "";
  return fmt::format(
      "; p_kin, {:.2g} of p, holds their flow against gammadot y, which p_kin of "
      "the profiles does not",
      kinetic_share);
}

/// (<m dv_x^2> - <m dv_y^2>)^(1/2) / (<m>^(1/2) gammadot L_y), where the first is 2 delta_p_kin/n.
double excess_along(FinishedRun const& finished, double height) {
  auto const& [run, found] = finished;
  bool const by_area = run.scene.mass_by_area();
  double const mass = (disk_mass(by_area, small_diameter) + disk_mass(by_area, big_diameter)) / 2;
  double const density = static_cast<double>(run.scene.disks.count) / finished.box_area();
  double const square = 2 * finished.mean("delta_p_kin") / density / mass;
  return std::sqrt(std::max(0.0, square)) / (run.scene.shear.strain_rate * height);
}

/// A state has as many disks as it has.
std::string more_disks(FinishedRun const& finished) {
  if (finished.run.scene.start.kind == "state") return "";
  return changed_run("disks.count", fmt::format("{}", 4 * finished.run.scene.disks.count));
}

}  // namespace

std::optional<Warning> box_size(FinishedRun const& finished) {
  double const scale = std::sqrt(finished.box_area() / finished.run.box_area());
  double const anisotropy = finished.mean("R_v"), length = scale * finished.run.box_length;
  double const height = scale * finished.run.box_height();
  double const kinetic_share = finished.mean("p_kin") / finished.mean("p");
  double const least = std::min(length, height);
  auto const momentum = net_momentum(finished);
  bool const moves_as_one = momentum && !momentum->is_note;  // which raises R_v
  double const excess = excess_along(finished, height);
  bool const met = !few_collisions(finished);  // else R_v is what the start was
  if (met && anisotropy > most_anisotropy && excess > least_of_bands && !moves_as_one)
    return Warning{
        "box_size",
        {{"R_v", anisotropy},
         {"excess_along_flow", excess},
         {"box_height", height},
         {"p_kin_share", kinetic_share}},
        fmt::format("R_v = {:.2g}, about 1 in a homogeneous flow (P2 Fig. 24), and disks move "
                    "along the flow by {:.2g} gammadot L_y: bands as wide as the box of {:.3g} d_s "
                    "across the flow lets them be{}",
                    anisotropy, excess, height, flow_of_bands(kinetic_share)),
        "compare with more disks, and see measure.profiles",
        more_disks(finished),
        /*is_note=*/true};
  if (least < least_length && finished.run.plan.has_one_rate())
    return Warning{
        "box_size",
        {{"box_length", length}, {"box_height", height}},
        fmt::format("the box is {:.3g} d_s {}, less than {}: B and eta may be off by several "
                    "standard errors",
                    least, height < length ? "high" : "wide", least_length),
        "compare with more disks",
        more_disks(finished),
        /*is_note=*/true};
  return {};
}

}  // namespace bagnold
