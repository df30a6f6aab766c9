// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "kernels/physics/drives/stokes_drag.hpp"
#include "src/run/warnings/checks.hpp"

namespace bagnold {

namespace {

constexpr double most_kinetic_in_drag = 3e-4;  ///< p_kin / p; docs/results/bubbles.md

}  // namespace

std::optional<Warning> drag_inertia(FinishedRun const& finished) {
  auto const& drive = finished.run.scene.drive;
  auto const& shear = finished.run.scene.shear;
  if (drive.kind != StokesDrag::name) return {};
  double const kinetic = finished.mean("p_kin") / finished.mean("p");
  if (!(kinetic > most_kinetic_in_drag)) return {};
  return Warning{
      "drag_inertia",
      {{"p_kin_share", kinetic}},
      fmt::format("p_kin/p = {:.2g} (above {:g}): inertia has a part in this flow, so it is not "
                  "that of bubbles, which depends on gammadot zeta alone",
                  kinetic, most_kinetic_in_drag),
      fmt::format(
          "for bubbles raise drive.drag = {}{}", drive.drag,
          shear.finds_rate()
              ? ""
              : fmt::format(" and lower shear.strain_rate = {} by one factor", shear.strain_rate)),
      "",
      /*is_note=*/true};
}

}  // namespace bagnold
