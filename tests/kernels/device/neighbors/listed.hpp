// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/kernels/device/neighbors/lists.hpp"

/// Lists that grow old: the disks move on and the box shears after the build.
namespace bagnold::test {

/// Disks as they were listed, and what has happened to them since.
template <class Space>
struct Listed {
  Disks at_build;
  double length;
  double offset;  ///< at the build
  double skin;
  VerletList<Space> list{};
  Rows rows{};

  Listed(Disks const& disks, double box_length, double offset_at_build, double list_skin)
      : at_build(disks), length(box_length), offset(offset_at_build), skin(list_skin) {
    rebuild(list, at_build, length, offset, skin);
    rows = rows_of(list.rows);
  }

  /// The disks carried on by the mean flow, and each by its own non-affine displacement w besides.
  Disks moved(double strain, std::vector<Vec2<Real>> const& w) const {
    Disks now = at_build;
    for (std::size_t i = 0; i < now.count(); ++i) {
      now.position[i].x += strain * at_build.position[i].y + w[i].x;
      now.position[i].y += w[i].y;
    }
    return now;
  }

  bool holds(Disks const& now, double strain) const {
    double largest2 = 0.0;
    for (std::size_t i = 0; i < now.count(); ++i)
      largest2 = std::max(largest2, nonaffine2(now.position[i], at_build.position[i], strain));
    return list_holds(strain, largest2, skin);
  }

  /// Pairs in contact that the list has not. Its images have gone on with the offset since.
  std::size_t missed(Disks const& now, double strain) const {
    Rows const contacts = all_pairs(now, length, offset + strain * length, 0.0);
    std::size_t count = 0;
    for (std::size_t i = 0; i < contacts.size(); ++i)
      for (Entry const& entry : contacts[i]) count += !has(i, entry);
    return count;
  }

  bool has(std::size_t i, Entry const& entry) const {
    return std::binary_search(rows[i].begin(), rows[i].end(), entry);
  }
};

/// 60 disks at an area fraction near 0.86; at a skin of 1.5 the box is almost the narrowest.
template <class Space>
Listed<Space> random_list(double skin, std::mt19937_64& random) {
  double const length = std::max(narrowest(skin), 8.5);
  double const offset = std::uniform_real_distribution<double>(0.0, length)(random);
  return {anywhere(60, length, random), length, offset, skin};
}

/// The largest common non-affine displacement that list_holds allows at this strain, by bisection;
/// 0 if none.
inline double allowed_nonaffine(double strain, double skin) {
  double low = 0.0, high = skin;
  for (int k = 0; k < 60; ++k) {
    double const middle = (low + high) / 2;
    (list_holds(strain, middle * middle, skin) ? low : high) = middle;
  }
  return low;
}

/// The strain at which |S^-1| d_max has grown by the skin, so that no disk need move at all: from
/// s = |gamma|/2 + sqrt(1 + gamma^2/4) follows |gamma| = s - 1/s.
inline double widest_strain(double skin) {
  double const s = 1.0 + skin / big_diameter;
  return s - 1.0 / s;
}

inline constexpr double skins[] = {0.05, 0.2, 0.6, 1.5};

}  // namespace bagnold::test
