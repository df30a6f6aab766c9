// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "src/config/jamming.hpp"
#include "src/run/warnings/checks.hpp"

namespace bagnold {

namespace {

constexpr double most_off = 0.1;  ///< relative

/// Rough exponent beta of B and eta ~ (phi_J - phi)^-beta: for lasting contacts as tried in
/// docs/stability.md. It is 1 in a gas: p grows with the collision rate and the temperature does
/// not, since shear heats and collisions cool in proportion to it.
double divergence(double contacts_per_disk) { return contacts_per_disk < 1 ? 1.0 : 2.5; }

}  // namespace

std::optional<Warning> hard_core_limit(FinishedRun const& finished) {
  double const phi = finished.run.scene.disks.packing_fraction;
  double const overlap = mean_overlap(finished);
  if (!(phi < jamming_fraction) || !(overlap > 0)) return {};
  // Disks that overlap by x on average are like hard ones with (1 - x) of the diameter: of phi - 2
  // phi x.
  double const looser = 2 * phi * overlap / (jamming_fraction - phi);
  double const off = 1 - std::pow(1 + looser, -divergence(finished.mean("Z")));
  if (off < most_off) return {};
  return Warning{"hard_core_limit",
                 {{"mean_overlap", overlap}, {"looser", looser}, {"estimated_change", -off}},
                 fmt::format("contacts overlap by {:.2g}% on average, as if packed {:.2g}% further "
                             "from jamming: B and "
                             "eta may be {:.0f}% below those of hard disks",
                             100 * overlap, 100 * looser, 100 * off),
                 "lower shear.strain_rate, or compare with half of it",
                 "bagnold check-limit DIR/scene.toml --out DIR-limit",
                 /*is_note=*/true};
}

}  // namespace bagnold
