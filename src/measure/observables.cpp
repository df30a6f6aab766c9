// SPDX-License-Identifier: BSD-3-Clause
#include "src/measure/observables.hpp"

#include <algorithm>
#include <cmath>

#include "kernels/physics/sums/sums.hpp"
#include "src/config/time_step.hpp"
#include "src/engine/contacts/contact_columns.hpp"
#include "src/engine/control_columns.hpp"
#include "src/engine/drive_columns.hpp"

namespace bagnold {

namespace {

using Averages = std::span<double const>;
using C = SumColumns;

/// (p_xx, p_xy, p_yy) L_x L_y of one part of the pressure tensor.
struct Part {
  int xx, xy, yy;
};
constexpr Part elastic{C::elastic_xx, C::elastic_xy, C::elastic_yy};
constexpr Part dissipative{C::dissipative_xx, C::dissipative_xy, C::dissipative_yy};
constexpr Part kinetic{C::kinetic_xx, C::kinetic_xy, C::kinetic_yy};

double total(Averages a, int Part::*component) {
  return a[elastic.*component] + a[dissipative.*component] + a[kinetic.*component];
}

double pressure(Averages a, Part p) { return (a[p.xx] + a[p.yy]) / 2; }
double pressure(Averages a) { return (total(a, &Part::xx) + total(a, &Part::yy)) / 2; }
double shear_stress(Averages a, Part p) { return -a[p.xy]; }
double shear_stress(Averages a) { return -total(a, &Part::xy); }
double anisotropy(Averages a, Part p) { return (a[p.xx] - a[p.yy]) / 2; }
double anisotropy(Averages a) { return (total(a, &Part::xx) - total(a, &Part::yy)) / 2; }

constexpr std::string_view stress_unit = "m/tau_e^2";

/// Correlation of the velocity at the contact, V^C_T = V_T + V^R (P2 Eqs. 30-34), with its
/// rotational part. sum(averages, column): of ContactColumns.
template <class Sum>
void add_rotation_in_contact(std::vector<Observable>& list, Sum const& sum) {
  using M = ContactMotion;
  auto const mean = [sum](Averages a, int column) {
    return sum(a, ContactColumns::motion + column) /
           sum(a, int{ContactColumns::motion} + M::contacts);
  };
  auto const at_contact2 = [mean](Averages a) {
    return mean(a, M::tangential2) + 2 * mean(a, M::tangential_rotational) +
           mean(a, M::rotational2);
  };
  list.push_back({"v_C_T_rms", "d_s/tau_e", "across it at the point of contact",
                  [=](Averages a) { return std::sqrt(at_contact2(a)); }});
  list.push_back({"v_R_rms", "d_s/tau_e", "of that the part of the rotation",
                  [=](Averages a) { return std::sqrt(mean(a, M::rotational2)); }});
  list.push_back(
      {"contact_rotation_correlation", "1",
       "correlation coefficient of V^C_T with V^R over contacts in time", [=](Averages a) {
         double const turn = mean(a, M::rotational);
         double const slip = mean(a, M::tangential) + turn;
         double const both = mean(a, M::tangential_rotational) + mean(a, M::rotational2);
         return (both - slip * turn) /
                std::sqrt((at_contact2(a) - slip * slip) * (mean(a, M::rotational2) - turn * turn));
       }});
}

/// True of a quantity that is over a power of the strain rate, which has no one value in a run by
/// pieces.
bool is_over_rate(std::string_view name) {
  for (std::string_view const start : {"B_", "eta_", "spin_"})
    if (name.starts_with(start)) return true;
  for (std::string_view const one : {"I", "energy_gap", "torque_power", "drag_power", "push_power"})
    if (name == one) return true;
  return false;
}

/// Adds the observables of contacts. By their definition Z = 2 tau_dur nu_coll.
void add_contacts(Scene const& scene, std::vector<Observable>& list) {
  using K = ContactColumns;
  using M = ContactMotion;
  int const first = engine_columns(scene.rotates(), scene.driven());
  auto const sum = [first](Averages a, int column) {
    return a[static_cast<std::size_t>(first + column)];
  };
  auto const rms = [sum](int column) {
    return [=](Averages a) { return std::sqrt(sum(a, column) / (a[C::contacts] / 2)); };
  };
  double const dt = time_step(scene), n = static_cast<double>(scene.disks.count);
  list.push_back({"tau_dur", "tau_e", "mean duration of contacts",
                  [=](Averages a) { return dt * sum(a, K::duration) / sum(a, K::ended); }});
  list.push_back({"nu_coll", "1/tau_e", "contacts begun per disk and time",
                  [=](Averages a) { return sum(a, K::begun) / (n * dt * sum(a, K::steps)); }});
  list.push_back({"nu_end", "1/tau_e", "contacts ended per disk and time, their duration known",
                  [=](Averages a) { return sum(a, K::ended) / (n * dt * sum(a, K::steps)); }});
  list.push_back({"v_N_rms", "d_s/tau_e", "relative velocity in contact, along the line of centres",
                  rms(int{K::motion} + M::normal2)});
  list.push_back({"v_T_rms", "d_s/tau_e", "across it", rms(int{K::motion} + M::tangential2)});
  if (scene.rotates()) add_rotation_in_contact(list, sum);
  list.push_back({"cluster_binary_share", "1",
                  "share of contacts in which neither disk ever touched a third one",
                  [=](Averages a) { return sum(a, K::binary) / sum(a, K::ended); }});
}

std::size_t control_column(Scene const& scene, int column) {
  return static_cast<std::size_t>(engine_columns(scene.rotates(), scene.driven()) + column);
}

/// Adds observables over the mean strain rate, of a flow at given stress.
void add_strain_rate(Scene const& scene, double area, std::vector<Observable>& list) {
  auto const at = control_column(scene, ControlColumns::strain_rate);
  double const elasticity = scene.disks.elasticity;
  list.push_back(
      {"strain_rate", "1/tau_e", "gammadot, mean over time", [=](Averages a) { return a[at]; }});
  list.push_back({"eta_sigma", "1", "viscosity Q sigma/gammadot",
                  [=](Averages a) { return elasticity * shear_stress(a) / (area * a[at]); }});
  list.push_back({"I", "1", "inertial number gammadot/sqrt(p), P1 Eq. 20",
                  [=](Averages a) { return a[at] / std::sqrt(pressure(a) / area); }});
}

/// Adds the packing fraction of a box that changes, and takes T_g of its disks.
void add_box(Scene const& scene, std::vector<Observable>& list) {
  auto const phi = control_column(scene, ControlColumns::packing_fraction);
  auto const kinetic = control_column(scene, ControlColumns::kinetic);
  double const n = static_cast<double>(scene.disks.count);
  list.push_back(
      {"packing_fraction", "1", "phi, mean over time", [=](Averages a) { return a[phi]; }});
  std::ranges::find(list, "T_g", &Observable::name)->value = [=](Averages a) {
    return a[kinetic] / n;
  };
}

}  // namespace

std::vector<Observable> observables(Scene const& scene, double box_length) {
  double const area = scene.disks.box_aspect * box_length * box_length;
  double const rate = scene.shear.strain_rate;
  double const n = static_cast<double>(scene.disks.count);
  double const bagnold = 1 / (area * rate * rate);               // P1 Eq. 16, P2 Eq. 19
  double const newton = scene.disks.elasticity / (area * rate);  // P2 Eq. 20
  auto const of = [](auto function, auto part, double factor) {
    return [=](Averages a) { return function(a, part) * factor; };
  };
  auto const p = [](Averages a, auto part) { return pressure(a, part); };
  auto const s = [](Averages a, auto part) { return shear_stress(a, part); };
  auto const d = [](Averages a, auto part) { return anisotropy(a, part); };

  auto const drive = static_cast<std::size_t>(engine_columns(scene.rotates(), false));
  auto const driven = [drive, acts = scene.driven()](Averages a) {
    return acts ? a[drive + DriveColumns::push] - a[drive + DriveColumns::drag] : 0;
  };

  std::vector<Observable> list{
      {"p", stress_unit, "pressure", [=](Averages a) { return pressure(a) / area; }},
      {"p_el", stress_unit, "its elastic part", of(p, elastic, 1 / area)},
      {"p_dis", stress_unit, "its dissipative part", of(p, dissipative, 1 / area)},
      {"p_kin", stress_unit, "its kinetic part", of(p, kinetic, 1 / area)},
      {"sigma", stress_unit, "shear stress -p_xy",
       [=](Averages a) { return shear_stress(a) / area; }},
      {"sigma_el", stress_unit, "its elastic part", of(s, elastic, 1 / area)},
      {"sigma_dis", stress_unit, "its dissipative part", of(s, dissipative, 1 / area)},
      {"sigma_kin", stress_unit, "its kinetic part", of(s, kinetic, 1 / area)},
      {"delta_p", stress_unit, "(p_xx - p_yy)/2", [=](Averages a) { return anisotropy(a) / area; }},
      {"delta_p_el", stress_unit, "its elastic part", of(d, elastic, 1 / area)},
      {"delta_p_dis", stress_unit, "its dissipative part", of(d, dissipative, 1 / area)},
      {"delta_p_kin", stress_unit, "its kinetic part", of(d, kinetic, 1 / area)},
      {"sigma_dev", stress_unit, "sqrt(delta_p^2 + sigma^2)",
       [=](Averages a) { return std::hypot(anisotropy(a), shear_stress(a)) / area; }},
      {"B_p", "1", "Bagnold coefficient p/gammadot^2",
       [=](Averages a) { return pressure(a) * bagnold; }},
      {"B_p_el", "1", "its elastic part", of(p, elastic, bagnold)},
      {"B_p_dis", "1", "its dissipative part", of(p, dissipative, bagnold)},
      {"B_p_kin", "1", "its kinetic part", of(p, kinetic, bagnold)},
      {"B_sigma", "1", "Bagnold coefficient sigma/gammadot^2",
       [=](Averages a) { return shear_stress(a) * bagnold; }},
      {"B_sigma_el", "1", "its elastic part", of(s, elastic, bagnold)},
      {"B_sigma_dis", "1", "its dissipative part", of(s, dissipative, bagnold)},
      {"B_sigma_kin", "1", "its kinetic part", of(s, kinetic, bagnold)},
      {"eta_p", "1", "Q p/gammadot", [=](Averages a) { return pressure(a) * newton; }},
      {"eta_p_el", "1", "its elastic part", of(p, elastic, newton)},
      {"eta_sigma", "1", "viscosity Q sigma/gammadot",
       [=](Averages a) { return shear_stress(a) * newton; }},
      {"eta_sigma_el", "1", "its elastic part", of(s, elastic, newton)},
      {"mu", "1", "macroscopic friction sigma/p",
       [=](Averages a) { return shear_stress(a) / pressure(a); }},
      {"I", "1", "inertial number gammadot/sqrt(p), P1 Eq. 20",
       [=](Averages a) { return rate / std::sqrt(pressure(a) / area); }},
      {"T_g", "m d_s^2/tau_e^2", "granular temperature sum m dv^2/2N, so that p_kin = n T_g",
       [=](Averages a) { return pressure(a, kinetic) / n; }},
      {"Z", "1", "contacts per disk", [=](Averages a) { return a[C::contacts] / n; }},
      {"R_v", "1", "<dv_x^2>/<v_y^2>, P2 Eq. 37",
       [=](Averages a) { return a[C::velocity_x2] / a[C::velocity_y2]; }},
      {"energy_gap", "1",
       "1 - power that contacts and the drive take/(sigma gammadot L_x L_y): 0 if no energy is "
       "lost or made",
       [=](Averages a) { return 1 - (a[C::dissipation] - driven(a)) / (shear_stress(a) * rate); }},
      {"p_dis_share", "1", "p_dis/p: 0 over whole contacts",
       [=](Averages a) { return pressure(a, dissipative) / pressure(a); }}};
  if (scene.rotates()) {
    list.push_back({"spin_mean", "1", "<thetadot>/gammadot",
                    [=](Averages a) { return a[C::spin] / (n * rate); }});
    list.push_back({"spin_var", "1", "variance of thetadot/gammadot, P2 Eq. 28", [=](Averages a) {
                      double const mean = a[C::spin] / (n * rate);
                      return a[C::spin2] / (n * rate * rate) - mean * mean;
                    }});
    list.push_back({"torque_power", "1",
                    "power of the torques/(sigma gammadot L_x L_y): 0 if <V^C_T V^R> = 0",
                    [=](Averages a) { return a[C::torque_power] / (shear_stress(a) * rate); }});
  }
  if (scene.driven()) {
    list.push_back(
        {"drag_power", "1", "power that the drag takes/(sigma gammadot L_x L_y)",
         [=](Averages a) { return a[drive + DriveColumns::drag] / (shear_stress(a) * rate); }});
    list.push_back(
        {"push_power", "1",
         "power that the rest of the drive gives, of a bath its noise, over the same",
         [=](Averages a) { return a[drive + DriveColumns::push] / (shear_stress(a) * rate); }});
  }
  if (scene.measure.contacts) add_contacts(scene, list);
  if (scene.shear.changes_box()) add_box(scene, list);
  if (scene.shear.by_pieces()) {
    std::erase_if(list, [](Observable const& one) { return is_over_rate(one.name); });
    list.push_back({"dissipation", "m/tau_e^3", "power that contacts take, of an area of 1",
                    [=](Averages a) { return a[C::dissipation] / area; }});
  }
  if (scene.shear.finds_rate()) add_strain_rate(scene, area, list);
  return list;
}

}  // namespace bagnold
