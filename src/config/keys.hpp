// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <limits>
#include <string_view>
#include <vector>

#include "src/config/names.hpp"
#include "src/config/scene.hpp"

namespace bagnold {

/// Characters of names of keys, "table.key".
inline constexpr std::string_view key_letters =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.-";

/// One key of the scene file: its name, unit, meaning and range.
struct Key {
  std::string_view name;  ///< "table.key"
  std::string_view unit;
  std::string_view meaning;
  bool required = false;
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  bool open_below = false;  ///< `least` itself is not allowed
  std::vector<std::string_view> words = {};
  std::vector<std::string_view> protocols = {};  ///< that know the key; empty: all
};

/// True if a protocol has a key.
inline bool belongs(Key const& key, std::string_view protocol) {
  return key.protocols.empty() ||
         std::find(key.protocols.begin(), key.protocols.end(), protocol) != key.protocols.end();
}

inline constexpr bool required = true;
inline constexpr bool optional = false;
inline constexpr bool above = true;  ///< the lower bound itself is excluded

/// Calls visit(Key, member) for every key of a scene, in the order of the file. Reading, writing,
/// checking and documenting scenes all go through this one list.
template <class SceneType, class Visitor>
void for_each_key(SceneType& scene, Visitor&& visit) {
  auto& [title, disks, start, shear, drive, integration, measure, output] = scene;
  auto const exponents = force_exponents();
  constexpr double many = std::numeric_limits<double>::infinity();
  // asked again at each key: a reader learns the protocol on the way
  auto const is = [&chosen = shear.protocol](std::string_view protocol) {
    return chosen == protocol;
  };
  std::initializer_list<std::string_view> const one_way = {"steady", "cascade", "ramp"};
  auto const of = [](std::initializer_list<std::string_view> protocols, Key key) {
    key.protocols = protocols;
    return key;
  };

  visit(Key{"title", "", "shown in output", optional}, title);

  visit(Key{"disks.model", "", "contact law", required, 0, 0, false, model_names()}, disks.model);
  visit(Key{"disks.count", "", "number of disks N, even: half small, half big", required, 2, 2e8},
        disks.count);
  visit(Key{"disks.packing_fraction", "", "phi: area of the disks over area of the box", required,
            0, 1, above},
        disks.packing_fraction);
  visit(Key{"disks.box_aspect", "", "L_y / L_x: height of the box, across the flow, over its width",
            optional, 1.0 / 64, 64},
        disks.box_aspect);
  visit(Key{"disks.elasticity", "", "Q = tau_d/tau_e; k_d = 1/Q", required, 1e-3, 1e6},
        disks.elasticity);
  visit(Key{"disks.mass",
            "",
            "equal: m = 1 for all (P2); area: m = (pi/2) d^2 (P1)",
            required,
            0,
            0,
            false,
            {"equal", "area"}},
        disks.mass);
  visit(Key{"disks.seed", "", "of the random start", optional, 0, 9.2e18}, disks.seed);
  visit(Key{"disks.replicas", "", "systems side by side, of the seeds seed .. seed + R - 1",
            optional, 1, 4096},
        disks.replicas);
  visit(Key{"disks.damping_normal", "1/Q", normal_damping_meaning(), optional, 0, 1e6},
        disks.damping_normal);
  visit(Key{"disks.damping_tangential", "1/Q", tangential_damping_meaning(), optional, 0, 1e6},
        disks.damping_tangential);
  visit(Key{"disks.force_exponent", "", exponent_meaning(), optional, exponents.front(),
            exponents.back()},
        disks.force_exponent);

  visit(Key{"start.kind",
            "",
            "random positions, or a state file",
            optional,
            0,
            0,
            false,
            {"random", "state"}},
        start.kind);
  visit(Key{"start.file", "", "state file, relative to the scene file", optional}, start.file);
  visit(Key{"start.copies", "",
            "set copies of the state side by side until they fill disks.count and box_aspect",
            optional},
        start.copies);
  visit(Key{"start.rescale", "",
            "scale velocities and spins of a state made at another strain rate (P2 Eqs. 40-41)",
            optional},
        start.rescale);
  visit(Key{"start.relax", "", "push the overlapping disks of a state apart first", optional},
        start.relax);
  visit(Key{"start.overlap", "", "relative overlap at which a start is relaxed enough", optional, 0,
            0.05, above},
        start.overlap);
  visit(Key{"start.iterations", "", "most iterations of that relaxation", optional, 0, 1e8},
        start.iterations);

  visit(Key{"shear.protocol", "", "what is done to the strain rate", optional, 0, 0, false,
            protocol_names()},
        shear.protocol);
  visit(of({"steady", "ramp", "stress", "pressure"},
           Key{"shear.strain_rate", "1/tau_e",
               "gammadot; of a ramp the lowest; at given stress that of the start",
               is("steady") || is("ramp") || is("stress"), 0, 1, above}),
        shear.strain_rate);
  visit(of({"cascade"}, Key{"shear.strain_rates", "1/tau_e",
                            "gammadot of each stage, largest first", is("cascade"), 0, 1, above}),
        shear.strain_rates);
  visit(of({"steady", "cascade", "ramp", "pressure"},
           Key{"shear.strain", "", "gamma, total; of a ramp at its lowest rate, before it",
               is("steady") || is("cascade") || is("pressure"), 0, 1e9, above}),
        shear.strain);
  visit(
      of({"steady", "cascade", "sequence", "oscillate", "stress", "pressure"},
         Key{"shear.discard", "",
             "share of the strain not measured, rounded up to whole windows, or \"auto\": MSER-5; "
             "of each piece of a sequence, of the cycles of an oscillation, of the time of a "
             "stress",
             optional, 0, 1}),
      shear.discard);
  visit(of({"steady", "cascade", "pressure"},
           Key{"shear.target_error", "",
               "relative standard errors of NAMEs at which a run ends before `strain`", optional, 0,
               1, above}),
        shear.target_error);
  visit(of({"ramp"}, Key{"shear.ramp_rate", "1/tau_e", "kappa~, decades a time, P2 Eq. 39",
                         is("ramp"), 0, 0.1, above}),
        shear.ramp_rate);
  visit(of({"ramp"}, Key{"shear.strain_rate_high", "1/tau_e", "gammadot up to which a ramp goes",
                         is("ramp"), 0, 1, above}),
        shear.strain_rate_high);
  visit(of({"ramp", "sequence", "oscillate"},
           Key{"shear.cycles", "", "times up and down, through the pieces, or back and forth",
               is("oscillate"), 1, 1e6}),
        shear.cycles);
  visit(of({"ramp"}, Key{"shear.ramp_window", "tau_e", "window whose averages are recorded",
                         optional, 0, many, above}),
        shear.ramp_window);
  visit(of({"ramp"}, Key{"shear.ramp_every", "tau_e", "between changes of the strain rate",
                         optional, 0, 1e6, above}),
        shear.ramp_every);
  visit(of({"sequence"},
           Key{"shear.pieces", "1/tau_e, tau_e",
               "[gammadot, strain] of each piece, gammadot of any sign; a stop is [0, time]",
               is("sequence"), -1, 1}),
        shear.pieces);
  visit(of({"oscillate"}, Key{"shear.amplitude", "", "gamma_0, of gamma = gamma_0 sin(2 pi t/T)",
                              is("oscillate"), 0, 10, above}),
        shear.amplitude);
  visit(of({"oscillate"}, Key{"shear.period", "tau_e", "T, or \"auto\": from peak_rate", optional,
                              0, 1e12, above}),
        shear.period);
  visit(of({"oscillate"}, Key{"shear.peak_rate", "1/tau_e",
                              "gamma_0 2 pi/T, or \"auto\": from period", optional, 0, 1, above}),
        shear.peak_rate);
  visit(of({"oscillate"}, Key{"shear.cycle_pieces", "", "pieces of a cycle, each at one rate",
                              optional, 8, 65536}),
        shear.cycle_pieces);
  visit(of({"stress"},
           Key{"shear.stress", "m/tau_e^2", "sigma to be held; or a list, one after the other",
               is("stress"), 0, 10, above}),
        shear.stress);
  visit(of({"stress"},
           Key{"shear.time", "tau_e", "that each stress is held", is("stress"), 0, 1e12, above}),
        shear.time);
  visit(of({"stress"}, Key{"shear.box_inertia", "m",
                           "M of the box: M dgammadot/dt = stress - sigma, or \"auto\": 0.5 "
                           "stress/strain_rate^2",
                           optional, 0, 1e15, above}),
        shear.box_inertia);
  visit(of({"pressure"}, Key{"shear.pressure", "m/tau_e^2", "p to be held by the size of the box",
                             is("pressure"), 0, 10, above}),
        shear.pressure);
  visit(of({"pressure"},
           Key{"shear.inertial_number", "",
               "I = strain_rate/sqrt(pressure), instead of strain_rate", optional, 0, 10, above}),
        shear.inertial_number);
  visit(of({"pressure"},
           Key{"shear.response", "", "gamma_p: d ln(area)/d gamma = (p/pressure - 1)/gamma_p",
               optional, 0, 1e6, above}),
        shear.response);

  visit(Key{"drive.kind", "", "force on each disk alone, P2 Sec. IV", optional, 0, 0, false,
            drive_words()},
        drive.kind);
  visit(Key{"drive.drag", "m/tau_e", "zeta: drag -zeta [v - u(r)] in the mean flow u", optional, 0,
            1e3},
        drive.drag);
  visit(Key{"drive.temperature", "m d_s^2/tau_e^2", "T of a thermal drive", optional, 0, 1e3},
        drive.temperature);

  visit(Key{"integration.scheme", "",
            "how the motion is stepped, or \"auto\": the cheapest way whose bias, as the run "
            "measures it, is within accuracy; the default from a strain of 4 on",
            optional, 0, 0, false, scheme_words()},
        integration.scheme);
  visit(
      Key{"integration.engine", "",
          "how the scheme is computed, none changes the physics; \"quasi-static\": by long steps, "
          "for flows that creep; \"events\": contacts in closed form, for dilute flows; \"auto\": "
          "these or \"steps\", by turns",
          optional, 0, 0, false, engine_words()},
      integration.engine);
  visit(Key{"integration.time_step",
            "tau_e",
            "dt, or \"auto\": the scheme's rule, or \"paper\": the papers'; quasi-static: a strain "
            "of "
            "1e-3",
            optional,
            0,
            1e12,
            above,
            {automatic, of_papers}},
        integration.time_step);
  visit(Key{"integration.skin",
            "d_s",
            "neighbour list reaches this far beyond contact; auto: 0.35, or 0.5 with "
            "implicit-damping",
            optional,
            0.01,
            10,
            false,
            {automatic}},
        integration.skin);
  visit(of({"steady", "cascade"}, Key{"integration.accuracy", "",
                                      "relative bias of p, sigma and Z that scheme = \"auto\" may "
                                      "have, or measure.bias accepts",
                                      optional, 0, 1, above}),
        integration.accuracy);

  visit(Key{"measure.every", "steps", "between evaluations inside a window; quasi-static: of all",
            optional, 1, 1e12},
        measure.every);
  visit(of({"steady", "cascade"},
           Key{"measure.bias", "",
               "bias of scheme and time step, by pairs of short stretches with a finer method",
               optional}),
        measure.bias);
  visit(of(one_way, Key{"measure.contacts", "", "durations, rate, angles and clusters of contacts",
                        optional}),
        measure.contacts);
  visit(
      of({"steady", "cascade"},
         Key{"measure.correlations", "",
             "relative velocities in contact, of contacts in time and once a collision", optional}),
      measure.correlations);
  visit(of({"steady", "cascade"},
           Key{"measure.clusters", "",
               "with correlations: velocities in contact by the size of the cluster", optional}),
        measure.clusters);
  visit(
      of(one_way, Key{"measure.contact_frames", "",
                      "contacts in the frames of trajectory.h5md, with forces and ages", optional}),
      measure.contact_frames);
  visit(of(one_way, Key{"measure.profiles", "",
                        "profiles over y of flow, packing and stress; band fractions", optional}),
        measure.profiles);
  visit(of(one_way, Key{"measure.fields", "",
                        "packing fraction and strain rate within 4 d_s of each disk", optional}),
        measure.fields);
  visit(of(one_way, Key{"measure.rotation", "", "histogram of thetadot/gammadot", optional}),
        measure.rotation);
  visit(of({"steady", "cascade"},
           Key{"measure.frame_strain", "", "between the frames that these three look at", optional,
               0, many, above}),
        measure.frame_strain);
  visit(of({"ramp"}, Key{"measure.frame_decades", "",
                         "of the rate, between these frames, each of which is told by itself",
                         optional, 0, 100, above}),
        measure.frame_decades);

  visit(of({"steady", "cascade", "sequence", "stress", "pressure"},
           Key{"output.sample_strain", "",
               "window whose averages are recorded; at given stress at the rate of the start",
               optional, 0, many, above}),
        output.sample_strain);
  visit(of({"steady", "cascade", "pressure"},
           Key{"output.trajectory_strain", "", "between the frames of trajectory.h5md; 0: none",
               optional, 0, many}),
        output.trajectory_strain);
  visit(of({"ramp"},
           Key{"output.trajectory_decades", "",
               "of the rate, between the frames of trajectory.h5md; 0: none", optional, 0, 100}),
        output.trajectory_decades);
  visit(of({"sequence", "oscillate", "stress"},
           Key{"output.trajectory_time", "tau_e", "between the frames of trajectory.h5md; 0: none",
               optional, 0, many}),
        output.trajectory_time);
  visit(Key{"output.checkpoint_minutes", "min", "wall time between checkpoints", optional, 0, many,
            above},
        output.checkpoint_minutes);
  visit(Key{"output.plot", "", "draw plot.png", optional}, output.plot);
}

}  // namespace bagnold
