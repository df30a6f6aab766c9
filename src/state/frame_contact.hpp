// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace bagnold {

/// A contact in one configuration. Forces act on i from j; what acts on j is opposite.
struct FrameContact {
  std::uint32_t i = 0, j = 0;                    ///< disks in the order of the start, i < j
  double overlap = 0;                            ///< d_ij - r_ij, [d_s]
  std::array<double, 2> normal = {};             ///< r_ij / |r_ij|: from j to i
  std::array<double, 2> velocity = {};           ///< of i against the image of j where the
                                                 ///< dissipative force acts, [d_s / tau_e]
  double elastic_force = 0;                      ///< along `normal`, [m d_s / tau_e^2]
  std::array<double, 2> dissipative_force = {};  ///< [m d_s / tau_e^2]
  double age = 0;  ///< since it began, NaN: at the start of the run, or before, [tau_e]
};

using FrameContacts = std::vector<FrameContact>;

}  // namespace bagnold
