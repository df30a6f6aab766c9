// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

/// Shear bands in profiles over the bins of one period, y = (b + 1/2) L/n, [d_s].
namespace bagnold {

/// Centre of the band that shears fastest, [d_s] in 0 .. L.
///
/// excess: v_x - gammadot y, a periodic function. The first Fourier mode of its derivative, Re[2 pi
/// i/L C exp(2 pi i y/L)] with C = sum_b excess_b exp(-2 pi i y_b/L), is largest at y = -L arg(i
/// C)/2 pi.
double band_position(std::span<double const> excess, double length);

/// Share of the period where a profile, a straight line from bin to bin, is below a level.
///
/// P2 App. B: f = w_B/L_y with the width of the Bagnoldian band cut from phi(y) by the global phi;
/// f' is 1 less that of gammadot(y) at the global gammadot. Without bands they are near 1/2.
double share_below(std::span<double const> profile, double level);

/// Mean of a profile over the eighth of the period in which the mean of `rate` is largest: a local
/// value in the band that shears fastest (P2 Fig. 35), or with -rate in the slowest. Without bands
/// it is that of the largest fluctuation. NaN where a bin of either has no value.
double in_fastest_band(std::span<double const> rate, std::span<double const> profile);

}  // namespace bagnold
