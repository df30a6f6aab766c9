// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "src/engine/quasi_static/newton.hpp"
#include "src/engine/quasi_static/pair_list.hpp"
#include "src/engine/run_clock.hpp"
#include "src/engine/simulation.hpp"

namespace bagnold {

/// Backward Euler steps as long as a strain of 1e-3, on one thread of the host. The cost of a dense
/// creeping flow per strain is nearly independent of the rate.
///
///     M (u_n+1 - u_n) = h F(r_n+1, u_n+1),   r_n+1 = r_n + h u_n+1
///
/// solved for all disks together (quasi_static/newton.hpp). A step that does not converge is
/// halved. Configurations are evaluated where steps end, with the forces of the step.
template <bool Rotates>
class QuasiStaticEngine final : public Simulation {
 public:
  /// Starts from a snapshot; an empty `snapshot.list_position` means no list yet. The bits of a
  /// step depend on the state and the list alone, so a snapshot needs no memory.
  QuasiStaticEngine(quasi_static::Material material, StrainRates const& rates, double time_step,
                    double skin, Snapshot const& snapshot,
                    Real tolerance = quasi_static::default_tolerance);

  int columns() const override;
  std::int64_t step() const override { return step_; }
  void advance(std::int64_t steps, Sampling const& sampling, OpenWindows& windows) override;
  Snapshot snapshot() const override;
  State state() const override;

 private:
  static constexpr int unknowns = quasi_static::StepEquations<Rotates>::unknowns;

  /// Counters of reports, in every checkpoint.
  template <class Self, class Visit>
  static void visit_counters(Self& self, Visit const& visit) {
    visit("newton_iterations", self.counts_.iterations);
    visit("factorizations", self.counts_.factorizations);
    visit("force_evaluations", self.counts_.evaluations);
    visit("halved_steps", self.halved_);
  }

  /// Moment at a part of the present step.
  quasi_static::Moment moment(double part) const { return {clock_, step_, part}; }
  std::uint32_t count() const { return static_cast<std::uint32_t>(position_.size()); }

  void do_step();
  void do_parts();
  [[noreturn]] void stop(bool converged, quasi_static::Moment const& end) const;
  void renew_list(double part);
  void check_overlaps() const;
  void add_sums(std::int64_t window, OpenWindows& windows) const;
  State raw_state() const;

  quasi_static::Material material_;
  Real tolerance_;
  RunClock clock_;
  std::int64_t step_ = 0;
  std::vector<double> diameter_;  ///< [N], as files have it
  std::vector<Vec2<Real>> position_;
  Eigen::VectorXd motion_;
  quasi_static::PairList list_;
  std::int64_t builds_ = 0;
  quasi_static::StepEquations<Rotates> equations_;
  quasi_static::NewtonMatrix<Rotates> matrix_;
  quasi_static::SolveCounts counts_;
  std::int64_t halved_ = 0;
};

}  // namespace bagnold
