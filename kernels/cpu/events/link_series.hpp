// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cpu/events/series.hpp"

namespace bagnold::events {

/// Constants of a contact within a cluster.
struct LinkConstants {
  Real inverse_distance;  ///< 1/d_ij
  Real normal;            ///< k_n, [m / tau_e]
  Real tangential;        ///< k_t
};

/// Series of one contact of a cluster. With u = r^2 and L = ln(u)/2, so that L' = r . v/r^2, the
/// force on i from j is
///
///     f = g r - k_t (v - Omega z x r),   g = (1/r - 1/d_ij)/d_ij + (k_t - k_n) L',
///
/// Omega = (d_i thetadot_i + d_j thetadot_j)/(d_i + d_j), and the coefficients of all follow one
/// after the other from those of r: u q' = -u' q/2 for q = u^(-1/2), u L' = u'/2.
template <bool Rotates>
struct LinkSeries {
  Series x, y;    ///< r_ij, [d_s]
  Series u;       ///< r_ij^2
  Series q;       ///< 1/r_ij
  Series growth;  ///< L', [1 / tau_e]
  Series g;
  Series turn;  ///< Omega, [1 / tau_e]; of a law that rotates
  Real inverse_u;

  void start(Vec2<Real> const& separation) {
    x[0] = separation.x;
    y[0] = separation.y;
    u[0] = dot(separation, separation);
    q[0] = 1 / std::sqrt(u[0]);
    inverse_u = 1 / u[0];
  }

  /// Coefficient k of the force, where x, y have those up to k + 1, and turn up to k.
  template <int k>
  Vec2<Real> force(LinkConstants const& c) {
    u[k + 1] = square<k + 1>(x) + square<k + 1>(y);
    if constexpr (k > 0) {
      Real sum = 0;
      for (int j = 1; j <= k; ++j) sum += (j - 2 * k) * u[j] * q[k - j];
      q[k] = sum * (inverse_u / (2 * k));
    }
    Real slope = (k + 1) * u[k + 1] / 2;
    for (int j = 1; j <= k; ++j) slope -= u[j] * growth[k - j];
    growth[k] = slope * inverse_u;
    g[k] = c.inverse_distance * (k == 0 ? q[k] - c.inverse_distance : q[k]) +
           (c.tangential - c.normal) * growth[k];
    Vec2<Real> f{product<k>(x, g), product<k>(y, g)};
    Real vx = (k + 1) * x[k + 1], vy = (k + 1) * y[k + 1];
    if constexpr (Rotates) {
      vx += product<k>(turn, y);
      vy -= product<k>(turn, x);
    }
    f.x -= c.tangential * vx;
    f.y -= c.tangential * vy;
    return f;
  }

  /// The last coefficient of r and u, from those of both disks.
  template <int k, class Member>
  void finish(Member const& a, Member const& b) {
    x[k] = a.x[k] - b.x[k];
    y[k] = a.y[k] - b.y[k];
    u[k] = square<k>(x) + square<k>(y);
  }

  /// Coefficient k of the torque on i over d_i, and on j over d_j: -r x f_dis/(d_i + d_j).
  template <int k>
  Real torque_per_diameter(LinkConstants const& c) const {
    Real sum = -product<k>(turn, u);
    for (int j = 0; j <= k; ++j) sum += (k - j + 1) * (x[j] * y[k - j + 1] - y[j] * x[k - j + 1]);
    return c.inverse_distance * c.tangential * sum / 2;
  }
};

}  // namespace bagnold::events
