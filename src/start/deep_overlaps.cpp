// SPDX-License-Identifier: BSD-3-Clause
#include "src/start/deep_overlaps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "kernels/physics/laws/contact.hpp"
#include "kernels/physics/species.hpp"

namespace bagnold {

namespace {

constexpr double largest_of_packings = 0.5;  // relative overlap; deeper ones mean a wrong box

struct Placed {
  double x, y;  ///< in the box
  std::size_t disk;
};

/// x modulo length, in [0, length); 0 for numbers too large to have a remainder.
double modulo(double x, double length) {
  double const rest = x - length * std::floor(x / length);
  return rest >= 0 && rest < length ? rest : 0;
}

/// Disks in rows at least a big diameter high, each in the order of x.
class Rows {
 public:
  explicit Rows(State const& state)
      : width_(state.box_length),
        height_(state.box_height()),
        offset_(state.offset),
        rows_(static_cast<std::size_t>(std::max(1.0, std::floor(height_ / big_diameter)))) {
    for (std::size_t disk = 0; disk < state.count(); ++disk) {
      auto const [x, y] = state.position[disk];
      double const image = std::floor(y / height_);
      Placed const placed{modulo(x - image * offset_, width_), modulo(y, height_), disk};
      auto const row =
          static_cast<std::size_t>(placed.y / height_ * static_cast<double>(rows_.size()));
      rows_[std::min(row, rows_.size() - 1)].push_back(placed);
    }
    for (auto& row : rows_) std::ranges::sort(row, {}, &Placed::x);
  }

  /// Calls see(one, other, dx, dy) for each pair that may touch, once, until it returns false.
  template <class See>
  void for_each_pair(See const& see) const {
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      bool const top = r + 1 == rows_.size();
      for (Placed const& one : rows_[r]) {
        if (!in_row(one, rows_[r], 0, 0, /*later_only=*/true, see)) return;
        if (!in_row(one, rows_[top ? 0 : r + 1], top ? offset_ : 0, top ? height_ : 0,
                    /*later_only=*/false, see))
          return;
      }
    }
  }

 private:
  /// Calls see for the disks of a row, shifted, that are within a big diameter of a disk in x.
  template <class See>
  bool in_row(Placed const& one, std::vector<Placed> const& row, double x_shift, double y_shift,
              bool later_only, See const& see) const {
    double const from = modulo(one.x - x_shift - big_diameter, width_);
    auto next = std::ranges::lower_bound(row, from, {}, &Placed::x);
    for (std::size_t seen = 0; seen < row.size(); ++seen, ++next) {
      if (next == row.end()) next = row.begin();
      if (modulo(next->x - from, width_) > 2 * big_diameter) return true;
      double dx = next->x + x_shift - one.x;
      dx -= width_ * std::round(dx / width_);
      if (later_only ? next->disk > one.disk : next->disk != one.disk)
        if (!see(one.disk, next->disk, dx, next->y + y_shift - one.y)) return false;
    }
    return true;
  }

  double width_, height_, offset_;
  std::vector<std::vector<Placed>> rows_;
};

/// Calls see(one, other, overlap) for each pair that overlaps, until it returns false.
template <class See>
void for_each_overlap(State const& state, See const& see) {
  Rows(state).for_each_pair([&](std::size_t i, std::size_t j, double dx, double dy) {
    double const reach = (state.diameter[i] + state.diameter[j]) / 2;
    if (dx * dx + dy * dy > reach * reach) return true;
    return see(i, j, 1 - 2 * std::hypot(dx, dy) / (state.diameter[i] + state.diameter[j]));
  });
}

}  // namespace

DeepOverlaps deep_overlaps(State const& state, double limit) {
  DeepOverlaps found;
  for_each_overlap(state, [&](std::size_t i, std::size_t j, double overlap) {
    if (!(overlap > limit)) return true;
    if (overlap > found.deepest) {
      found.deepest = overlap;
      found.disk = std::min(i, j);
      found.neighbour = std::max(i, j);
    }
    return ++found.pairs < DeepOverlaps::most_pairs;
  });
  return found;
}

double largest_overlap(State const& state) {
  double largest = 0;
  for_each_overlap(state, [&](std::size_t, std::size_t, double overlap) {
    largest = std::max(largest, overlap);
    return true;
  });
  return largest;
}

std::string deep_overlap_warning(State const& state, std::string const& file) {
  auto const found = deep_overlaps(state, largest_relative_overlap);
  if (found.pairs == 0) return {};
  auto const what = fmt::format(
      "{}: {}{} pair{} of disks overlap{} by more than {:.0f}%, disks {} and {} (from 0) by "
      "{:.3g}%: the run stops there; ",
      file, found.pairs == DeepOverlaps::most_pairs ? "at least " : "", found.pairs,
      found.pairs == 1 ? "" : "s", found.pairs == 1 ? "s" : "", 100 * largest_relative_overlap,
      found.disk, found.neighbour, 100 * found.deepest);
  if (found.deepest > largest_of_packings)
    return what + fmt::format(
                      "no packing has overlaps above {:.0f}%: the box (L_x = {:.6g}, L_y = {:.6g}, "
                      "offset {:.6g}) or the diameters are not those of the disks, as a rule; look "
                      "at what made the file",
                      100 * largest_of_packings, state.box_length, state.box_height(),
                      state.offset);
  return what +
         "push them apart by start.relax = true, or let start.kind = \"random\" make a state";
}

}  // namespace bagnold
