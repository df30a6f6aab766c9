// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <utility>

#include "src/run/results.hpp"

namespace bagnold {

/// Windows of a protocol that comes by the same place several times, taken together by pass. A pass
/// is one way through the place, of one replica.
struct Passes {
  std::size_t windows = 0;                                        ///< of all passes
  std::map<std::pair<std::size_t, std::int64_t>, WindowSums> of;  ///< by replica and pass

  void add(std::pair<std::size_t, std::int64_t> pass, std::span<double const> sums, double weight);

  /// A row a pass.
  statistics::Windows table() const;
};

/// Pass of a cycle of a replica. From 3 replicas on all cycles of one are one pass: those of a
/// packing that comes back are not independent.
std::pair<std::size_t, std::int64_t> pass_of(Run const& run, std::size_t replica,
                                             std::int64_t cycle);

/// Mean over all passes, and from 3 passes on the error by the jackknife that leaves out one at a
/// time; with fewer there is none: within a pass windows follow one another.
statistics::Estimate estimate_of_passes(statistics::Windows const& passes,
                                        statistics::Function const& f);

}  // namespace bagnold
