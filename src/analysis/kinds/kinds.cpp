// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/kinds/kinds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "src/config/errors.hpp"
#include "src/config/nearest_word.hpp"

namespace bagnold::analysis {
namespace {

constexpr std::array all{
    Kind{"crossover", "y = C [1 + (Q/Q*)^s]^(q/s)", "P1 Sec. III A, Figs. 1, 3, 5",
         "--y [B_p_el], --x [disks.elasticity], --fix NAME=VALUE", crossover},
    Kind{"divergence", "Q*(phi) = Q0 + c (phi_J - phi)^-x", "P1 Sec. III B, Fig. 5a; P2 Fig. 3",
         "--of crossover|jump|transition|value, --phi-j VALUE fixes phi_J, else it is free, --fix, "
         "--weigh",
         divergence},
    Kind{"friction-law", "mu = mu_J + c I^b", "P1 Eq. (21), Fig. 15",
         "--fix mu_J=VALUE, --range of I, --along KEY", friction_law},
    Kind{"exponents", "d ln y / d ln x, over a few points at a time and over all",
         "P1 Figs. 7, 14b (beta_eff, a_eff)",
         "--x [phi_J-phi] --y [B_p], --phi-j VALUE, --window POINTS", exponents},
    Kind{"transition", "two lines through y(gammadot_1) - y(gammadot_2) meet at the transition",
         "P2 App. A, Figs. 32, 33",
         "--x disks.elasticity|disks.packing_fraction, --y [Z/shear.strain_rate or B_p_el], "
         "--rates G1 G2, --split X, --log-x, --log-y",
         transition},
    Kind{"kink", "y = a + b x + sum_k c_k max(0, x - x_k)", "P2 Figs. 22, 23, 30",
         "--x [disks.packing_fraction] --y [p_el], --kinks 1|2, --log-x, --log-y, --curved, "
         "--direction",
         kink},
    Kind{"jump", "middle of the steepest change of ln y", "P2 Fig. 24 (R_v); Figs. 1, 3 (Q_c)",
         "--x [disks.packing_fraction] --y [R_v], --direction up|down|both, --least-factor F",
         jump},
    Kind{"peak", "vertex of the parabola through the highest point and its neighbours",
         "P2 Fig. 20b (the variance of rotation)", "--x [disks.packing_fraction] --y [spin_var]",
         peak},
    Kind{"constant-pressure", "where p = P, and y there, between neighbouring points",
         "P2 Figs. 25, 34", "--pressure P, --y [mu], --along [shear.strain_rate]",
         constant_pressure},
    Kind{"table", "means over seeds with errors", "", "--x KEY --y NAME for the picture",
         merged_table},
};

}  // namespace

std::span<Kind const> kinds() { return all; }

Kind const& kind_of(std::string_view name) {
  auto const found = std::ranges::find(all, name, &Kind::name);
  if (found != all.end()) return *found;
  std::vector<std::string> known;
  for (auto const& kind : all) known.emplace_back(kind.name);
  throw InputError(fmt::format("analyse {} (no such kind){} There are: {}", name,
                               did_you_mean(std::string(name), known, "."), fmt::join(known, " ")));
}

}  // namespace bagnold::analysis
