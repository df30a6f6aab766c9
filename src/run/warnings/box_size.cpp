// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "src/run/warnings/checks.hpp"

namespace bagnold {

namespace {

constexpr double most_anisotropy = 2;  ///< R_v of a homogeneous flow is about 1, P2 Fig. 24
constexpr double least_length = 12;    ///< [d_s]: about 100 disks
constexpr double worth_a_word = 0.01;  ///< p_kin / p, as large as the biases of time steps

/// p_kin is of velocities against gammadot y, P2 Eq. 14 of those against the average profile.
std::string flow_of_bands(double kinetic_share) {
  if (!(kinetic_share > worth_a_word)) return "";
  return fmt::format(
      "; p_kin, {:.2g} of p, holds their flow against gammadot y, which p_kin of "
      "the profiles does not",
      kinetic_share);
}

std::string more_disks(FinishedRun const& finished) {
  return changed_run("disks.count", fmt::format("{}", 4 * finished.run.scene.disks.count));
}

}  // namespace

std::optional<Warning> box_size(FinishedRun const& finished) {
  double const anisotropy = finished.mean("R_v"), length = finished.run.box_length;
  double const height = finished.run.box_height();
  double const kinetic_share = finished.mean("p_kin") / finished.mean("p");
  double const least = std::min(length, height);
  if (anisotropy > most_anisotropy)
    return Warning{
        "box_size",
        {{"R_v", anisotropy}, {"box_height", height}, {"p_kin_share", kinetic_share}},
        fmt::format("R_v = {:.2g}, about 1 in a homogeneous flow (P2 Fig. 24): bands as wide as "
                    "the box of {:.3g} d_s across the flow lets them be{}",
                    anisotropy, height, flow_of_bands(kinetic_share)),
        "compare with more disks, and see measure.profiles",
        more_disks(finished),
        /*is_note=*/true};
  if (least < least_length && !finished.run.plan.ramp)
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
