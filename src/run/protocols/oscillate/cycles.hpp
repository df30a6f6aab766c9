// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "src/run/results.hpp"
#include "src/statistics/tables.hpp"

namespace bagnold {

/// Answer of a flow to the strain gamma_0 sin(omega t), cycle by cycle:
///
///     sigma(t) = sigma_0 + D (t/T - 1/2) + gamma_0 sum_n [G'_n sin(n omega t) + G''_n cos(n omega
///     t)]
///
/// A fit of least squares to the stress of the K windows of a cycle. G'_1 and G''_1 are the
/// storage modulus G' and the loss modulus G''. Their terms are the strain and the strain rate of
/// the windows themselves, which are linear and constant in a piece: so the fit is exact for sigma
/// = G gamma + eta gammadot, whatever K is. D is the drift of a packing that still relaxes, whose
/// projection on the sine would be a G' of -D/(pi gamma_0): the mean difference of windows a period
/// apart, about the ends of the cycle. Of a single cycle it is fitted beside the harmonics.
struct Cycles {
  std::vector<statistics::Windows> of;  ///< [R]: a row a cycle that has come to its end
  std::size_t discarded = 0;            ///< first rows, of the transient
  std::vector<Observable>
      observables;           ///< of these rows: averages over cycles, then what is fitted
  std::size_t averages = 0;  ///< number of the former
};

/// Cycles of a run with shear.protocol = "oscillate".
Cycles cycles_of(Run const& run);

/// Moduli of each cycle, for result.h5.
statistics::Samples cycle_table(Run const& run);

/// Stress over a cycle, by window, averaged over measured cycles and replicas.
struct Waveform {
  std::vector<double> strain, strain_rate;            ///< [K], at the mean time of its samples
  std::vector<statistics::Estimate> sigma, pressure;  ///< [K], [m/tau_e^2]
};

Waveform waveform_of(Run const& run);

}  // namespace bagnold
