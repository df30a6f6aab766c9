// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "bench/rows.hpp"
#include "src/config/plan.hpp"
#include "src/config/scene.hpp"
#include "src/engine/simulation.hpp"
#include "src/run/run_measured.hpp"

namespace bagnold::bench {

/// What the engines have counted, all replicas together.
struct Counts {
  double pairs = 0;          ///< evaluated in steps one by one, twice a step
  double prunings = 0;       ///< of the inner list
  double builds = 0;         ///< of the outer list
  double one_by_one = 0;     ///< steps
  double looking_ahead = 0;  ///< steps

  friend Counts operator-(Counts const& a, Counts const& b) {
    return {a.pairs - b.pairs, a.prunings - b.prunings, a.builds - b.builds,
            a.one_by_one - b.one_by_one, a.looking_ahead - b.looking_ahead};
  }
};

/// The systems of a row, at the end of an untimed tenth of its strain: schemes chosen, lists built.
class RowSystems {
 public:
  /// Throws InputError where the state is missing or does not fit.
  RowSystems(Row const& row, std::string const& engine, RowOptions const& options);

  void run();  ///< to the end, sampling as `bagnold run` does
  Counts counts() const;
  double disk_steps() const;  ///< of run(), all replicas together
  double strain() const;      ///< of run()
  double strain_done() const { return strain() * static_cast<double>(simulations_.size()); }

 private:
  Scene scene_;
  Plan plan_;
  int side_by_side_;
  std::int64_t untimed_;
  std::vector<std::unique_ptr<Simulation>> simulations_;  ///< [R]
  std::vector<Measurement> measurements_;                 ///< [R]
};

}  // namespace bagnold::bench
