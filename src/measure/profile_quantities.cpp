// SPDX-License-Identifier: BSD-3-Clause
#include "src/measure/profile_quantities.hpp"

namespace bagnold {

namespace {

using C = SliceColumns;
using Averages = std::span<double const>;

double flow(Averages s) { return s[C::flow_x] / s[C::mass]; }

/// sum m a b about the straight lines that fit a and b, from the sums of m a, m h a, m b, m h b.
double about_flow(Averages s, double ab, int a, int ha, int b, int hb) {
  double const M = s[C::mass], H = s[C::height];
  double const spread = s[C::height2] - H * H / M;
  double const a_slope = s[ha] - H * s[a] / M, b_slope = s[hb] - H * s[b] / M;
  double const along = spread > 0 ? a_slope * b_slope / spread : 0.0;
  return ab - s[a] * s[b] / M - along;
}

double kinetic_xx(Averages s) {
  return about_flow(s, s[C::kinetic_xx], C::flow_x, C::shear_x, C::flow_x, C::shear_x);
}
double kinetic_xy(Averages s) {
  return about_flow(s, s[C::kinetic_xy], C::flow_x, C::shear_x, C::flow_y, C::shear_y);
}
double kinetic_yy(Averages s) {
  return about_flow(s, s[C::kinetic_yy], C::flow_y, C::shear_y, C::flow_y, C::shear_y);
}

double p_el(Averages s) { return (s[C::elastic_xx] + s[C::elastic_yy]) / 2; }
double p_dis(Averages s) { return (s[C::dissipative_xx] + s[C::dissipative_yy]) / 2; }
double p_kin(Averages s) { return (kinetic_xx(s) + kinetic_yy(s)) / 2; }
double sigma_el(Averages s) { return -s[C::elastic_xy]; }
double sigma_dis(Averages s) { return -s[C::dissipative_xy]; }
double sigma_kin(Averages s) { return -kinetic_xy(s); }
double p(Averages s) { return p_el(s) + p_dis(s) + p_kin(s); }
double sigma(Averages s) { return sigma_el(s) + sigma_dis(s) + sigma_kin(s); }

}  // namespace

std::vector<ProfileQuantity> profile_quantities(Slices const& slices, double strain_rate,
                                                bool rotates) {
  double const thickness = slices.thickness();
  double const area = slices.width * thickness;
  auto const here = [](auto function, double factor = 1.0) {
    return [=](Averages three) { return factor * function(three.subspan(C::count, C::count)); };
  };
  auto const column = [](int c, double factor) {
    return [=](Averages three) { return factor * three[C::count + c]; };
  };
  constexpr std::string_view stress = "m/tau_e^2";
  std::vector<ProfileQuantity> list{
      {"v_x", "d_s/tau_e", "velocity of the mean flow", here(flow), true},
      {"gammadot", "1/tau_e", "dv_x/dy, from the two slices beside",
       [=](Averages three) {
         double const rise = flow(three.subspan(2 * C::count)) - flow(three);
         return strain_rate + rise / (2 * thickness);
       }},
      {"phi", "1", "packing fraction, disks cut at the edges of the slice",
       column(C::area, 1 / area)},
      {"T_g", "m d_s^2/tau_e^2", "sum m dv^2/2N about the local mean flow",
       here([](Averages s) { return p_kin(s) / s[C::disks]; })},
      {"Z", "1", "contacts per disk",
       here([](Averages s) { return s[C::contacts] / s[C::disks]; })},
      {"p", stress, "pressure, the kinetic part about the local mean flow", here(p, 1 / area)},
      {"p_el", stress, "its elastic part", here(p_el, 1 / area)},
      {"p_dis", stress, "its dissipative part", here(p_dis, 1 / area)},
      {"p_kin", stress, "its kinetic part", here(p_kin, 1 / area)},
      {"sigma", stress, "shear stress -p_xy, the kinetic part about the local mean flow",
       here(sigma, 1 / area)},
      {"sigma_el", stress, "its elastic part", here(sigma_el, 1 / area)},
      {"sigma_dis", stress, "its dissipative part", here(sigma_dis, 1 / area)},
      {"sigma_kin", stress, "its kinetic part", here(sigma_kin, 1 / area)}};
  if (rotates)
    list.push_back({"spin_mean", "1", "<thetadot>/gammadot, gammadot that of the whole box",
                    here([=](Averages s) { return s[C::spin] / (s[C::disks] * strain_rate); })});
  return list;
}

}  // namespace bagnold
