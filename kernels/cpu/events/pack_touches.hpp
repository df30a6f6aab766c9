// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "kernels/cpu/events/image_shifts.hpp"
#include "kernels/cpu/events/path.hpp"
#include "kernels/cpu/simd/pack.hpp"

namespace bagnold::events {

/// A disk against a pack of its neighbours, all on their lines: LinePair for each lane, and the
/// same to the last bit where a neighbour asks for the disk.
class PackTouches {
 public:
  unsigned near = 0;      ///< lanes that may touch before both are on their lines
  unsigned touching = 0;  ///< lanes that touch there, at time[lane]
  alignas(64) double time[simd::width];

  /// The disk: distances2 to small and big ones.
  PackTouches(Path const& path, double small2, double big2) : small2_(small2), big2_(big2) {
    own_ = {{path.place.x, path.place.y, path.velocity.x, path.velocity.y}};
    begun_ = path.begun;
    straight_ = path.straight;
    deviation_ = path.deviation;
  }

  /// The first `count` of these neighbours, width at most.
  void find(Path const* paths, ImageShifts const& shifts, Neighbor const* neighbors,
            std::uint32_t count) {
    using simd::Pack;
    constexpr int width = simd::width;
    Pack column[8];
    unsigned big = 0;
    for (int part = 0; part < 8; part += width) {
      Pack* const rows = column + part;
      for (std::uint32_t k = 0; k < width; ++k) {
        Neighbor const n = neighbors[std::min(k, count - 1)];
        auto const* const other = reinterpret_cast<double const*>(paths + n.index());
        rows[k] = (Pack::load(own_.x + part) - Pack::load(other + part)) -
                  Pack::load(shifts.row(n) + part);
        big |= static_cast<unsigned>(n.big()) << k;
      }
      simd::transpose(rows);
    }
    Pack const begun = simd::max(Pack(begun_), -column[4]);
    Pack const straight = simd::max(Pack(straight_), -column[5]);
    Pack const deviation = Pack(deviation_) - column[6], wait = straight - begun;
    Pack const vx = column[2], vy = column[3];
    Pack const x = fma(vx, straight, column[0]), y = fma(vy, straight, column[1]);
    Pack const approach = fma(y, vy, x * vx), velocity2 = fma(vy, vy, vx * vx);
    Pack const distance2 = select(simd::Mask::of(big), Pack(big2_), Pack(small2_));
    Pack const beyond = fma(y, y, fnma(Pack(1.0), distance2, x * x));
    Pack const reached = fma(velocity2 * wait, wait, deviation * deviation);
    Pack const zero(0.0);
    // r - d exceeds s, s^2 = 2 reached, where r^2 - d^2 exceeds s^2 + 2 d s. Paths bring a pair no
    // nearer than by |v| wait + deviation, which is s at most.
    Pack const excess = fnma(Pack(2.0), reached, beyond);
    auto const clear = (zero < excess) & (Pack(8.0) * distance2 * reached < excess * excess);
    Pack const discriminant = fnma(velocity2, beyond, approach * approach);
    auto const meet = clear & (approach < zero) & (zero < discriminant);
    unsigned const lanes = simd::first_lanes(count).lanes();
    near = ~clear.lanes() & lanes;
    touching = meet.lanes() & lanes;
    if (touching != 0)
      (straight + beyond / (simd::sqrt(simd::max(discriminant, zero)) - approach)).store(time);
  }

 private:
  struct alignas(64) Own {
    double x[8];
  };
  Own own_;
  double begun_, straight_, deviation_, small2_, big2_;
};

}  // namespace bagnold::events
