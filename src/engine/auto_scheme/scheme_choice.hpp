// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "kernels/physics/sums/sums.hpp"
#include "src/engine/sampling.hpp"

namespace bagnold {

/// Energy put in by the shear and taken out by damping, summed over evaluated configurations
/// (SumColumns).
struct EnergyBalance {
  double driven = 0;      ///< sigma gammadot L_x L_y
  double dissipated = 0;  ///< D

  /// 1 - D/(sigma gammadot L_x L_y): the share that becomes motion or elastic energy, or is lost by
  /// errors of a scheme.
  double gap() const { return 1 - dissipated / driven; }

  void add(std::vector<double> const& sums, double strain_rate) {
    using C = SumColumns;
    driven -= (sums[C::elastic_xy] + sums[C::dissipative_xy] + sums[C::kinetic_xy]) * strain_rate;
    dissipated += sums[C::dissipation];
  }
};

/// p_kin/p of sums over configurations; infinite where the pressure is not positive.
inline double kinetic_share(std::vector<double> const& sums) {
  using C = SumColumns;
  double const kinetic = sums[C::kinetic_xx] + sums[C::kinetic_yy];
  double const all = kinetic + sums[C::elastic_xx] + sums[C::elastic_yy] + sums[C::dissipative_xx] +
                     sums[C::dissipative_yy];
  return all > 0 ? kinetic / all : HUGE_VAL;
}

/// Choice of the scheme for the next stretch of a run: implicit damping where motions are
/// overdamped, otherwise two stages. Motions are overdamped if p_kin/p of the stretch is below
/// most_kinetic and the energy gap over strains of gap_strain is below most_gap; over such strains
/// stored elastic energy no longer blurs the gap (docs/accuracy.md, "Which scheme auto takes").
/// Where a stretch fails, two stages take the next stretches, twice as many as after the failure
/// before.
class SchemeChoice {
 public:
  static constexpr double most_kinetic = 1e-4;
  static constexpr double most_gap = 0.01;
  static constexpr double gap_strain = 2;
  static constexpr std::int64_t longest_pause = 1024;  ///< [stretches]

  /// True if p_kin/p is small enough; false if nothing was sampled.
  static bool is_overdamped(WindowSums const& sampled) {
    return sampled.weight > 0 && kinetic_share(sampled.sums) < most_kinetic;
  }

  bool implicit() const { return pause_left_ == 0; }

  /// Number of stretches left for two stages.
  std::int64_t pause_left() const { return pause_left_; }

  /// Counts a stretch of two stages.
  void explicit_stretch_done() { --pause_left_; }

  /// Judges a stretch of implicit damping. Returns whether it may be kept.
  bool keeps(WindowSums const& sampled, double strain, double strain_rate) {
    if (!is_overdamped(sampled)) return refuse();
    balance_.add(sampled.sums, strain_rate);
    balance_strain_ += strain;
    if (balance_strain_ < gap_strain) return keep();
    double const gap = balance_.gap();
    balance_ = {};
    balance_strain_ = 0;
    return std::abs(gap) < most_gap ? keep() : refuse();
  }

  /// Records a stretch that cannot be kept. Returns false.
  bool refuse() {
    pause_left_ = pause_;
    pause_ = std::min(2 * pause_, longest_pause);
    balance_ = {};
    balance_strain_ = 0;
    return false;
  }

  /// Visits the numbers on which the choice depends.
  template <class Visit>
  void for_each_memory(Visit const& visit) {
    visit("auto_pause", pause_);
    visit("auto_pause_left", pause_left_);
    visit("auto_driven", balance_.driven);
    visit("auto_dissipated", balance_.dissipated);
    visit("auto_balance_strain", balance_strain_);
  }

 private:
  bool keep() {
    pause_ = 1;
    return true;
  }

  std::int64_t pause_ = 1;       ///< after the next failure, [stretches]
  std::int64_t pause_left_ = 1;  ///< a start is not steady
  EnergyBalance balance_;        ///< since it was last evaluated
  double balance_strain_ = 0;
};

}  // namespace bagnold
