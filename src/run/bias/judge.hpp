// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "src/run/bias/stretch.hpp"

namespace bagnold::bias {

/// `none`: more pairs are needed; `open`: after the last look they still are; `usual`: of two
/// stages at their rule under scheme = "auto", which are not judged where usual_accuracy will do.
enum class Verdict { none, accepted, refused, open, usual };

std::string_view name_of(Verdict verdict);

/// Quantities that are judged, in the order of their biases; and sigma/p, which is not.
enum Quantity : std::size_t { pressure, shear_stress, contact_number, temperature, friction };
inline constexpr std::size_t quantities = 5;
inline constexpr std::array<std::string_view, quantities> quantity_names = {"p", "sigma", "Z",
                                                                            "T_g", "mu"};

/// A relative bias, with its 95% as judged and its standard error as stated.
struct Bias {
  double value = 0, bound = 0, error = 0;
};

/// What pairs say of a method.
///
/// b = sum coarse/sum fine - 1 over M pairs. With r = coarse - (1 + b) fine of each,
///
///     e = t_95(M - 1) [|r|^2/(M (M - 1))/mean(fine)^2 + (2e-4)^2]^(1/2)
///
/// In a gas, 2 p_kin/sigma > 0.1, T_g relaxes over a strain of 2 p_kin/sigma, which is longer than
/// a stretch. There b of T_g is the slope of (coarse - fine)/fine over the strain times 2
/// p_kin/sigma.
struct Judgement {
  Verdict verdict = Verdict::none;
  bool gas = false;
  std::array<Bias, quantities> judged = {};  ///< as of the stretches

  /// As they come to in a long run. Its error is that of the pairs and half of what is stated, as
  /// differences still grow (more of it after short stretches); in a gas p follows T_g, and sigma
  /// and Z its root.
  std::array<Bias, quantities> stated = {};
};

/// Judges two pairs or more by a tolerance: refused where |b| - e exceeds it for p, sigma or Z, or
/// three times it for T_g; accepted where 1.5 |b| + e is below it for p, sigma and Z and |b| below
/// three times it for T_g. After shorter stretches than stretch_strain more is still to come: 2 |b|
/// after a quarter of it. In a gas T_g has the tolerance itself, |b| + e below it accepts, and a
/// collision must lose its energy within the tolerance. strain: of a stretch.
Judgement judge(std::span<Pair const> pairs, double tolerance, double strain,
                double collision_loss_error);

}  // namespace bagnold::bias
