// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "kernels/cpu/islands/flight_times.hpp"

namespace bagnold {

/// Times at which configurations are evaluated within a lookahead, and sums of powers of these
/// times.
class SampleTimes {
 public:
  /// Sums over samples, with t and q of FlightTimes: of q^2, q^2 t and q^2 t^2 for columns
  /// quadratic in the motion, of q for linear ones.
  struct Powers {
    Real n = 0, t1 = 0, t2 = 0;
    Real linear = 0;
    Real samples = 0;

    void add(Real t, Real q) {
      Real const square = q * q;
      n += square;
      t1 += square * t;
      t2 += square * t * t;
      linear += q;
      samples += 1;
    }
  };

  void clear() {
    step_.clear();
    bin_.clear();
    before_.clear();
    total_.clear();
  }

  /// step: from the start of the lookahead, ascending; bin: measurement window, from 0, ascending.
  void add(std::int64_t step, std::size_t bin, FlightTimes const& flights) {
    if (bin >= total_.size()) total_.resize(bin + 1);
    auto& total = total_[bin];
    step_.push_back(step);
    bin_.push_back(bin);
    before_.push_back(total);
    total.add(flights.time(step), flights.scale(step));
  }

  std::size_t size() const { return step_.size(); }
  std::size_t bins() const { return total_.size(); }
  std::int64_t step(std::size_t k) const { return step_[k]; }
  std::size_t bin(std::size_t k) const { return bin_[k]; }
  Powers const& total(std::size_t bin) const { return total_[bin]; }

  /// First sample from `step` on; size() if there is none.
  std::size_t from(std::int64_t step) const {
    return static_cast<std::size_t>(std::lower_bound(step_.begin(), step_.end(), step) -
                                    step_.begin());
  }

  /// Calls use(bin, powers) for the samples k .. end - 1, bin by bin; t and q from step `origin`.
  template <class Use>
  void some(std::size_t k, std::size_t end, std::int64_t origin, FlightTimes const& flights,
            Use const& use) const {
    while (k < end) {
      auto const bin = bin_[k];
      Powers powers;
      for (; k < end && bin_[k] == bin; ++k)
        powers.add(flights.time(origin, step_[k]), flights.scale(origin, step_[k]));
      use(bin, powers);
    }
  }

  /// Calls use(bin, powers) for the samples from number k on, bin by bin.
  template <class Use>
  void rest(std::size_t k, Use const& use) const {
    if (k >= size()) return;
    auto const& all = total_[bin_[k]];
    auto const& gone = before_[k];
    use(bin_[k], Powers{all.n - gone.n, all.t1 - gone.t1, all.t2 - gone.t2,
                        all.linear - gone.linear, all.samples - gone.samples});
    for (auto bin = bin_[k] + 1; bin < bins(); ++bin) use(bin, total_[bin]);
  }

 private:
  std::vector<std::int64_t> step_;
  std::vector<std::size_t> bin_;
  std::vector<Powers> before_;  ///< of the same bin, in front of a sample
  std::vector<Powers> total_;   ///< by bin
};

}  // namespace bagnold
