// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/paper_values.hpp"

#include <algorithm>
#include <cmath>

#include "kernels/physics/laws/cd_n.hpp"
#include "kernels/physics/laws/cd_rot.hpp"

namespace bagnold {

std::vector<PaperValue> paper_values(Scene const& scene, std::vector<Observable> const& list) {
  if (scene.shear.by_pieces()) return {};  // the papers have none
  using Averages = std::span<double const>;
  auto const& disks = scene.disks;
  double const phi = disks.packing_fraction, q = disks.elasticity;
  double const rate = scene.shear.strain_rate;
  auto const at = [&](double a, double b) { return std::abs(a - b) < 1e-9 * std::abs(b); };
  auto const of = [&](std::string_view name) {
    return std::find_if(list.begin(), list.end(), [&](auto const& o) { return o.name == name; })
        ->value;
  };
  auto const ratio = [&](std::string_view above, std::string_view below) {
    return [a = of(above), b = of(below)](Averages averages) { return a(averages) / b(averages); };
  };

  std::vector<PaperValue> values;
  if (disks.model == CDn::name && scene.mass_by_area()) {
    if (at(phi, 0.60))
      values.push_back({"p_kin/p", "about 0.10", "P1 Sec. III A", ratio("p_kin", "p")});
    if (at(phi, 0.835)) {
      values.push_back({"p_kin/p", "0.001 to 0.005", "P1 Sec. III A", ratio("p_kin", "p")});
      values.push_back({"|sigma_kin|/sigma", "0.0005 to 0.001", "P1 Sec. III A",
                        [r = ratio("sigma_kin", "sigma")](Averages a) { return std::abs(r(a)); }});
    }
    if (phi < 0.75 && q <= 10)
      values.push_back(
          {"delta_p/p", "0.05 to 0.12, smaller phi", "P1 Appendix", ratio("delta_p", "p")});
  }
  if (disks.model == CDrot::name) {
    values.push_back({"spin_mean", "about -1/2", "P2 Fig. 20", of("spin_mean")});
    bool const coexists = (at(phi, 0.7984) && at(rate, 3e-5)) ||
                          (at(phi, 0.792) && at(rate, 5e-5)) || (at(phi, 0.802) && at(rate, 2e-5));
    if (coexists && at(q, 1) && disks.count == 65536) {
      values.push_back({"p", "2e-5", "P2 Sec. III C 2", of("p")});
      values.push_back({"mu", "0.346", "P2 Appendix B", of("mu")});
    }
  }
  return values;
}

}  // namespace bagnold
