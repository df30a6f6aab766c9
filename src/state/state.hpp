// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace bagnold {

/// One system on the host, as made by starts and held in files: disks in the order of the start.
struct State {
  std::vector<std::array<double, 2>> position;  ///< [N], [d_s]
  std::vector<std::array<double, 2>> velocity;  ///< [N], lab frame, [d_s / tau_e]
  std::vector<double> spin;           ///< [N], [1 / tau_e], counter-clockwise; empty: no spins
  std::vector<double> diameter;       ///< [N], 1 or 1.4, [d_s]
  double box_length = 0.0;            ///< L_x, [d_s]
  double box_aspect = 1.0;            ///< L_y / L_x
  double offset = 0.0;                ///< gamma L_y modulo L_x: x of the image above, [d_s]
  double time = 0.0;                  ///< [tau_e]
  std::optional<double> strain_rate;  ///< of the run that made it, [1 / tau_e]

  std::size_t count() const { return position.size(); }
  double box_height() const { return box_aspect * box_length; }  ///< L_y, [d_s]
};

}  // namespace bagnold
