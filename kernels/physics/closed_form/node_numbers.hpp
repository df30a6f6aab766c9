// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/physics/vec2.hpp"

namespace bagnold {

/// A number at each node of Gauss's rule on (-1, 1), so that formulas written for numbers hold for
/// all nodes at once.
struct AtNodes {
  static constexpr int count = 8;
  using Lanes = Real __attribute__((vector_size(count * sizeof(Real))));
  Lanes v;

  AtNodes() = default;
  AtNodes(Lanes lanes) : v(lanes) {}
  AtNodes(Real x) : v{x, x, x, x, x, x, x, x} {}

  static AtNodes abscissas() {
    return Lanes{-0.9602898564975362317, -0.7966664774136267396, -0.5255324099163289858,
                 -0.1834346424956498049, 0.1834346424956498049,  0.5255324099163289858,
                 0.7966664774136267396,  0.9602898564975362317};
  }

  static AtNodes weights() {
    return Lanes{0.1012285362903762591, 0.2223810344533744706, 0.3137066458778872873,
                 0.3626837833783619830, 0.3626837833783619830, 0.3137066458778872873,
                 0.2223810344533744706, 0.1012285362903762591};
  }

  /// Integral over (-1, 1).
  Real integral() const {
    Lanes const w = v * weights().v;
    return ((w[0] + w[4]) + (w[1] + w[5])) + ((w[2] + w[6]) + (w[3] + w[7]));
  }

  AtNodes& operator+=(AtNodes const& b) {
    v = v + b.v;
    return *this;
  }
  friend AtNodes operator+(AtNodes const& a, AtNodes const& b) { return a.v + b.v; }
  friend AtNodes operator-(AtNodes const& a, AtNodes const& b) { return a.v - b.v; }
  friend AtNodes operator*(AtNodes const& a, AtNodes const& b) { return a.v * b.v; }
  friend AtNodes operator/(AtNodes const& a, AtNodes const& b) { return a.v / b.v; }
  friend AtNodes operator-(AtNodes const& a) { return -a.v; }
  friend AtNodes multiply_add(AtNodes const& a, AtNodes const& b, AtNodes const& c) {
    return a * b + c;
  }
};

}  // namespace bagnold
