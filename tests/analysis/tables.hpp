// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "src/analysis/curves.hpp"
#include "src/analysis/sweep_table.hpp"

namespace bagnold::analysis {

/// A grid of phi x rate x seed whose p tells which point it is: 100 phi + rate + seed / 1000.
inline SweepTable small_table() {
  SweepTable table;
  table.origin = "made";
  for (double const phi : {0.7, 0.6})
    for (double const rate : {1e-4, 1e-5})
      for (double const seed : {1, 2, 3}) {
        table.keys["disks.packing_fraction"].numbers.push_back(phi);
        table.keys["shear.strain_rate"].numbers.push_back(rate);
        table.keys["shear.strain"].numbers.push_back(rate == 1e-4 ? 20 : 10);
        table.keys["disks.seed"].numbers.push_back(seed);
        table.observables["p"].mean.push_back(100 * phi + rate + seed / 1000);
        table.observables["p"].error.push_back(0.001);
        ++table.points;
      }
  return table;
}

inline double const nothing = std::nan("");

}  // namespace bagnold::analysis
