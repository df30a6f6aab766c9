// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "src/config/drives.hpp"
#include "src/config/number_or_list.hpp"
#include "src/config/number_or_word.hpp"
#include "src/config/schemes.hpp"

namespace bagnold {

/// A piece of a sequence.
struct SequencePiece {
  double rate = 0;    ///< gammadot, of any sign, [1/tau_e]
  double amount = 0;  ///< |strain|, or where the rate is 0 the time, [tau_e]

  bool operator==(SequencePiece const&) const = default;
};

/// A scene: the input of one run. Units are d_s, m (P2) or m_0 (P1), tau_e; so k_e = 1.
///
/// Meaning, unit, range and allowed words of every member are in src/config/keys.hpp.
struct Scene {
  std::string title;

  struct Disks {
    std::string model;            ///< of a law in kernels/physics/laws
    std::int64_t count = 0;       ///< N
    double packing_fraction = 0;  ///< phi
    double elasticity = 0;        ///< Q
    std::string mass;             ///< "equal" or "area"
    std::int64_t seed = 1;
    std::int64_t replicas = 1;      ///< R: systems of the seeds seed .. seed + R - 1
    double damping_normal = 1;      ///< k_d^(n) Q
    double damping_tangential = 1;  ///< k_d^(t) Q
    double force_exponent = 2;      ///< alpha
    double box_aspect = 1;          ///< L_y / L_x
  } disks;

  struct Start {
    std::string kind = "random";  ///< or "state"
    std::string file;             ///< relative to the scene file; absolute once read
    bool copies = false;          ///< of a state, as many as fill the box
    bool rescale = true;
    bool relax = false;
    double overlap = 1e-4;
    std::int64_t iterations = 20000;
  } start;

  struct Shear {
    std::string protocol = "steady";
    double strain_rate = 0;               ///< gammadot; of a ramp the lowest
    std::vector<double> strain_rates;     ///< of a cascade, the largest first
    NumberOrList strain = 2.0;            ///< gamma; of a ramp: before it, at the lowest rate
    std::optional<double> discard = 0.5;  ///< none: "auto"
    std::map<std::string, double> target_error;  ///< relative standard error, by NAME
    double ramp_rate = 0;                        ///< kappa~, P2 Eq. 39
    double strain_rate_high = 0;
    std::int64_t cycles = 1;
    double ramp_window = 1e3;
    double ramp_every = 1;
    std::vector<SequencePiece> pieces;      ///< of a sequence
    double amplitude = 0;                   ///< gamma_0 of an oscillation
    std::optional<double> period;           ///< T of an oscillation; none: from peak_rate
    std::optional<double> peak_rate;        ///< none: from period
    std::int64_t cycle_pieces = 128;        ///< K of an oscillation
    NumberOrList stress = 0.0;              ///< sigma to be held, one after the other, [m/tau_e^2]
    double time = 0;                        ///< that each of them is held, [tau_e]
    std::optional<double> box_inertia;      ///< M, [m]; none: box_inertia(scene)
    double pressure = 0;                    ///< to be held, [m/tau_e^2]
    std::optional<double> inertial_number;  ///< gives strain_rate at that pressure
    double response = 10;                   ///< gamma_p: how slowly the box follows the pressure

    // Properties of the protocol, from its row in protocols.cpp.
    bool run_per_rate() const;  ///< each of a list of rates has a run and a folder of its own
    bool ramps() const;         ///< the rate changes over decades, and motions are scaled with it
    bool by_pieces() const;     ///< the rate changes, and motions keep their excess over the flow
    bool lists_pieces() const;  ///< rates and amounts of pieces are listed, with results of each
    bool oscillates() const;    ///< pieces make up cycles, with results of a mean cycle
    bool finds_rate() const;    ///< the mean strain rate is a result
    bool changes_box() const;   ///< the packing fraction is a result
    bool lengthens() const;     ///< a longer shear.strain goes on from the end of the run

    /// True if the sums of a piece decide on the next one's strain rate or box.
    bool controlled() const { return finds_rate() || changes_box(); }

    /// True if the strain rate is given and stays, in the one run or in each.
    bool rate_stays() const { return !ramps() && !by_pieces() && !controlled(); }

    /// True if one state is sought, with means of its own.
    bool has_one_flow() const { return !by_pieces() || (finds_rate() && !stress.is_list()); }
  } shear;

  /// A force on each disk alone, beside contacts.
  struct Drive {
    std::string kind = no_drive;  ///< or of a drive in kernels/physics/drives
    double drag = 0;              ///< zeta
    double temperature = 0;       ///< T
  } drive;

  struct Integration {
    std::string scheme = default_scheme;  ///< or "auto", which scheme_of(scene) resolves
    std::string engine = "auto";
    NumberOrWord time_step = automatic;  ///< dt; time_step(scene) resolves it
    NumberOrWord skin = automatic;       ///< skin(scene) resolves it
    double accuracy = 0.01;              ///< relative bias of p, sigma and Z that is allowed
  } integration;

  struct Measure {
    std::int64_t every = 10;
    bool bias = false;  ///< of the method, by pairs of stretches
    bool contacts = false;
    bool correlations = false;
    bool clusters = false;
    bool contact_frames = false;
    bool profiles = false;
    bool fields = false;
    bool rotation = false;
    double frame_strain = 0.1;
    double frame_decades = 0.05;  ///< of a ramp
  } measure;

  struct Output {
    double sample_strain = 1e-2;
    double trajectory_strain = 0.0;
    double trajectory_decades = 0.0;  ///< of a ramp
    double trajectory_time = 0.0;     ///< of pieces
    double checkpoint_minutes = 10.0;
    bool plot = true;
  } output;

  bool rotates() const;  ///< whether disks have spins
  bool driven() const { return drive.kind != no_drive; }
  bool mass_by_area() const { return disks.mass == "area"; }
  double box_length() const;  ///< L_x, [d_s], P1 Eq. (8), P2 Eq. (11)
  double box_height() const { return disks.box_aspect * box_length(); }  ///< L_y, [d_s]
};

}  // namespace bagnold
