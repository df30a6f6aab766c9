// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace bagnold::statistics {

/// One level of blocking: statistics of the series in blocks of `length` values.
struct BlockLevel {
  std::size_t length;     ///< B = 2^k
  std::size_t blocks;     ///< floor(blocks of the level before / 2); an odd one out is left off
  double standard_error;  ///< se_B: of the mean, were the blocks independent; unit of the series
};

/// Levels of blocking, Flyvbjerg and Petersen, J. Chem. Phys. 91, 461 (1989). Neighbours are
/// averaged in pairs, again and again, as long as two blocks are left; at each level
///
///     se_B^2 = sum_b (x_b - mean)^2 / [n_B (n_B - 1)].
///
/// se_B grows with B until blocks are longer than the correlation, and stays there.
std::vector<BlockLevel> block_levels(std::span<double const> series);

/// First level with B^3 > 2 n (se_B / se_1)^4, n values in all; none if no level has it.
///
/// Wolff, Comput. Phys. Commun. 156, 143 (2004), Eq. (47); Lee, Conduit, Nemec, Lopez Rios and
/// Drummond, PRE 83, 066706 (2011), Eq. (14); as in the program pyblock. With 2 tau = (se_B /
/// se_1)^2 it balances the bias of se_B^2, of relative size about tau / B, against its scatter, (2B
/// / n)^(1/2).
std::optional<BlockLevel> automatic_level(std::span<BlockLevel const> levels, std::size_t n);

/// tau_B = (1/2) (se_B / se_1)^2, in units of the spacing of the series: grows with B to tau_int,
/// which is 1/2 without correlation and (1 + rho) / (2 (1 - rho)) for a first-order autoregressive
/// series. n / (2 tau_int) independent values would have the same error.
double correlation_time(double standard_error, double first_standard_error);

/// Block length that solves the criterion of automatic_level() for B, not rounded to a power of 2:
/// (8 n tau^2)^(1/3), rounded up. It gives more blocks. With powers of 2 most runs of about 100 tau
/// have fewer than 8 blocks, and the few that have 8 are those whose tau came out too small.
std::size_t block_length(double tau, std::size_t n);

/// tau_int from tau_B. Blocks of B values miss the correlation across their ends: for correlations
/// that decay exponentially (a sum over the geometric series)
///
///     tau_B = tau - (tau^2 - 1/4) / B,
///
/// here solved for tau, at most B / 2. Left alone where tau_B <= 1/2, which is a little too large
/// for an alternating series.
double without_end_effect(double tau_of_blocks, std::size_t length);

}  // namespace bagnold::statistics
