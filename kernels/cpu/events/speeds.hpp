// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <iterator>
#include <vector>

#include "kernels/physics/vec2.hpp"

namespace bagnold::events {

/// How fast time goes in a window, g(x), x since its begin: constant, or in steps.
class Speeds {
 public:
  /// Between two times, s since the first.
  struct Integrals {
    Real one, time, time2;  ///< of g, g s, g s^2
    Real length;            ///< of 1
  };

  void clear() { pieces_.clear(), changes_ = false; }

  /// A speed from a time on, 0 for the first.
  void add(Real from, Real speed) {
    Piece piece{from, speed, {}};
    if (!pieces_.empty()) {
      auto const& last = pieces_.back();
      for (int k = 0; k < 3; ++k) piece.moment[k] = last.to(k, from);
    }
    pieces_.push_back(piece);
    changes_ = changes_ || speed != 1;
  }

  /// True if the speed has been other than 1.
  bool change() const { return changes_; }

  Integrals between(Real from, Real until) const {
    Real const s = until - from;
    auto const &first = piece(from), &last = piece(until);
    Real const g = first.speed;
    if (&first == &last) return {g * s, g * s * s / 2, g * s * s * s / 3, s};
    Real over[3];
    for (int k = 0; k < 3; ++k) over[k] = last.to(k, until) - first.to(k, from);
    return {over[0], over[1] - from * over[0], over[2] - from * (2 * over[1] - from * over[0]), s};
  }

 private:
  struct Piece {
    Real from, speed;
    Real moment[3];  ///< of g, g x, g x^2, before it

    Real to(int k, Real x) const {
      Real now = x, then = from;
      for (int n = 0; n < k; ++n) now *= x, then *= from;
      return moment[k] + speed * (now - then) / (k + 1);
    }
  };

  Piece const& piece(Real time) const {
    auto const next = std::ranges::upper_bound(pieces_, time, {}, &Piece::from);
    return next == pieces_.begin() ? *next : *std::prev(next);
  }

  std::vector<Piece> pieces_;
  bool changes_ = false;
};

}  // namespace bagnold::events
