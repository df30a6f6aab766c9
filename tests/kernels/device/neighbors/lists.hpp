// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstdint>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "kernels/device/neighbors/verlet_list.hpp"
#include "src/engine/device_copy.hpp"

/// Neighbour lists on the host, and the same by brute force.
namespace bagnold::test {

/// The image of disk j at (x_j + m L_x + n gamma L_y, y_j + n L_y).
struct Entry {
  std::uint32_t j;
  int m;
  int n;
  auto operator<=>(Entry const&) const = default;
};

using Rows = std::vector<std::vector<Entry>>;

struct Disks {
  std::vector<Vec2<Real>> position;
  std::vector<double> diameter;

  std::size_t count() const { return position.size(); }
};

/// Disks anywhere in the box: every third one big, overlapping as it comes.
inline Disks anywhere(std::size_t count, ShearedBox const& box, std::mt19937_64& random) {
  std::uniform_real_distribution<double> along(0.0, box.length), across(0.0, box.height);
  Disks disks;
  for (std::size_t i = 0; i < count; ++i) {
    disks.position.push_back({along(random), across(random)});
    disks.diameter.push_back(i % 3 == 0 ? 1.4 : 1.0);
  }
  return disks;
}

/// In a square box.
inline Disks anywhere(std::size_t count, double length, std::mt19937_64& random) {
  return anywhere(count, ShearedBox{length, 0.0, 0.0}, random);
}

/// Every pair image with r_ij < d_ij + margin, both ways: all disks, more images than there can be.
/// Disks may be out of the box by about its width.
inline Rows all_pairs(Disks const& disks, ShearedBox const& box, double margin) {
  Rows rows(disks.count());
  for (std::uint32_t i = 0; i < disks.count(); ++i) {
    for (std::uint32_t j = 0; j < disks.count(); ++j) {
      if (i == j) continue;
      double const reach = (disks.diameter[i] + disks.diameter[j]) / 2 + margin;
      for (int n = -2; n <= 2; ++n) {
        double const y = disks.position[i].y - (disks.position[j].y + n * box.height);
        if (std::abs(y) >= reach) continue;
        for (int m = -4; m <= 4; ++m) {
          double const shift = m * box.length + n * box.offset;
          double const x = disks.position[i].x - (disks.position[j].x + shift);
          if (std::sqrt(x * x + y * y) < reach) rows[i].push_back({j, m, n});
        }
      }
    }
    std::sort(rows[i].begin(), rows[i].end());
  }
  return rows;
}

/// In a square box.
inline Rows all_pairs(Disks const& disks, double length, double offset, double margin) {
  return all_pairs(disks, ShearedBox{length, offset, 0.0}, margin);
}

/// What a list holds, in its own order.
template <class Space>
Rows rows_of(NeighborRows<Space> const& neighbors) {
  auto const row = to_host(neighbors.row);
  auto const entries = to_host(neighbors.entries);
  Rows rows(row.size() - 1);
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (auto k = row[i]; k < row[i + 1]; ++k)
      rows[i].push_back({entries[k].index(), entries[k].image().m, entries[k].image().n});
  return rows;
}

/// Puts the list of these disks, in the box, into `list`, which may hold another list of as many.
template <class Space>
void rebuild(VerletList<Space>& list, Disks const& disks, ShearedBox const& box, double skin) {
  list.skin = skin;
  list.at_build = to_device<Space>("test::at_build", disks.position);
  build_list(Space{}, list, to_device<Space>("test::species", species_of(disks.diameter)),
             make_species_table(false), box);
}

/// In a square box.
template <class Space>
void rebuild(VerletList<Space>& list, Disks const& disks, double length, double offset,
             double skin) {
  rebuild(list, disks, ShearedBox{length, offset, 0.0}, skin);
}

/// The first row in which two lists differ, with what only one of them has; empty if they are
/// equal.
inline std::string difference(Rows const& found, Rows const& expected) {
  if (found.size() != expected.size()) return "different numbers of rows";
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (found[i] == expected[i]) continue;
    std::ostringstream text;
    auto const list = [&](char const* what, auto const& here, auto const& there) {
      for (Entry const& entry : here)
        if (std::find(there.begin(), there.end(), entry) == there.end())
          text << what << entry.j << " (" << entry.m << ", " << entry.n << ")";
    };
    text << "row " << i;
    list("; lacks ", expected[i], found[i]);
    list("; should not have ", found[i], expected[i]);
    return text.str();
  }
  return "";
}

/// The narrowest box in which a pair can meet through one image only.
inline double narrowest(double skin) { return 2 * (big_diameter + skin); }

}  // namespace bagnold::test
