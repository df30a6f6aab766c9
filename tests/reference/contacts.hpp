// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "tests/reference/parameters.hpp"

namespace bagnold::reference {

/// Disk i and one image of disk j, i < j, closer than d_ij.
///
/// The image of a disk at (x, y) sits at (x + mL + n gamma L, y + nL) (P1 below Eq. 8, P2 below
/// Eq. 4); gamma grows, so the image moves with v_x + n gammadot L.
struct Contact {
  std::size_t i, j;
  int n, m;                 ///< image of j; m counts from gamma L reduced to [0, L)
  double x, y;              ///< r_ij = r_i - r_j(image), [d_s]
  double velocity_x;        ///< v_i - v_j(image), [d_s / tau_e]
  double velocity_y;        ///< same, y
  double separation;        ///< r_ij = |r_ij|, [d_s]
  double contact_distance;  ///< d_ij = (d_i + d_j) / 2, [d_s]
};

/// gamma L_y modulo L_x, in [0, L_x).
inline double reduced_offset(double strain, State const& box) {
  double const turns = strain * box.box_aspect;
  return (turns - std::floor(turns)) * box.box_length;
}

/// Every pair in contact, by rising i, then j, then image.
///
/// All images with r < d_ij count. Between disks in the box they have |n| <= 1 and |m| <= 2; the
/// range here is wider, so that one disk of a pair may also be given by a neighbouring image.
inline std::vector<Contact> contacts(Parameters const& p, State const& s, double strain) {
  std::vector<Contact> found;
  found.reserve(3 * s.count());
  double const width = s.box_length, height = s.box_height();
  double const offset = reduced_offset(strain, s);
  for (std::size_t i = 0; i < s.count(); ++i) {
    for (std::size_t j = i + 1; j < s.count(); ++j) {
      double const contact_distance = (s.diameter[i] + s.diameter[j]) / 2.0;
      for (int n = -2; n <= 2; ++n) {
        double const y = s.position[i][1] - (s.position[j][1] + n * height);
        if (std::abs(y) >= contact_distance) continue;
        for (int m = -4; m <= 4; ++m) {
          double const x = s.position[i][0] - (s.position[j][0] + m * width + n * offset);
          if (std::abs(x) >= contact_distance) continue;
          double const r = std::sqrt(x * x + y * y);
          if (r >= contact_distance) continue;
          double const vx = s.velocity[i][0] - (s.velocity[j][0] + n * p.strain_rate * height);
          double const vy = s.velocity[i][1] - s.velocity[j][1];
          found.push_back({i, j, n, m, x, y, vx, vy, r, contact_distance});
        }
      }
    }
  }
  return found;
}

/// Largest relative overlap 1 - r_ij / d_ij; 0 without contacts.
inline double largest_overlap(Parameters const& p, State const& s, double strain) {
  double largest = 0.0;
  for (Contact const& c : contacts(p, s, strain)) {
    largest = std::max(largest, 1.0 - c.separation / c.contact_distance);
  }
  return largest;
}

}  // namespace bagnold::reference
