// SPDX-License-Identifier: BSD-3-Clause
#include "kernels/physics/box/sheared_box.hpp"

#include <array>
#include <cmath>
#include <random>

#include "src/engine/device_copy.hpp"
#include "tests/support/typed.hpp"

namespace bagnold::test {
namespace {

struct Disk {
  Vec2<Real> position;
  Vec2<Real> velocity;
};

template <class Space>
std::vector<Disk> wrapped(ShearedBox const& box, std::vector<Disk> const& disks) {
  auto const device = to_device<Space>("test::disks", disks);
  Kokkos::parallel_for(
      "test::wrap", Kokkos::RangePolicy<Space>(0, disks.size()),
      KOKKOS_LAMBDA(std::int64_t i) { wrap(box, device(i).position, device(i).velocity.x); });
  return to_host(device);
}

/// How many of the neighbours (index, each of the 15 images) come back changed out of their word,
/// or share it with another image.
template <class Space>
int changed_by_packing(std::vector<std::uint32_t> const& indices) {
  auto const index = to_device<Space>("test::index", indices);
  int changed = 0;
  Kokkos::parallel_reduce(
      "test::pack", Kokkos::RangePolicy<Space>(0, indices.size()),
      KOKKOS_LAMBDA(std::int64_t k, int& sum) {
        std::uint32_t seen = 0;
        for (int n = -1; n <= 1; ++n) {
          for (int m = -2; m <= 2; ++m) {
            Neighbor const neighbor = Neighbor::make(index(k), Image{m, n});
            Image const image = neighbor.image();
            sum += !(neighbor.index() == index(k) && image.m == m && image.n == n);
            sum += (seen >> (neighbor.packed & 15u)) & 1u;
            seen |= 1u << (neighbor.packed & 15u);
          }
        }
      },
      changed);
  return changed;
}

/// Boxes at any instant: no offset, almost none, almost L_x, and past L_x as between list builds;
/// square, tall and flat.
std::vector<ShearedBox> boxes() {
  std::vector<ShearedBox> result;
  for (double length : {3.0, 7.3, 41.7})
    for (double offset : {0.0, 1e-12, 0.37 * length, std::nextafter(length, 0.0), 1.2 * length})
      for (double rate : {0.0, 1e-3, -0.2})
        for (double aspect : {1.0, 4.0, 0.25})
          result.push_back({length, offset, rate, aspect * length});
  return result;
}

/// Disks well inside the box, so that rounding cannot take one over an edge.
std::vector<Disk> inside(ShearedBox const& box, std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> share(1e-9, 1 - 1e-9);
  std::uniform_real_distribution<double> speed(-1.0, 1.0);
  std::vector<Disk> disks(count);
  for (Disk& disk : disks)
    disk = {{share(random) * box.length, share(random) * box.height},
            {speed(random), speed(random)}};
  return disks;
}

/// The image of a disk that sits m L_x + n gamma L_y to the right and n L_y above, and moves with
/// v_x + n gammadot L_y (P1 below Eq. 8, P2 below Eq. 4).
Disk image(ShearedBox const& box, Disk disk, int m, int n) {
  disk.position.x += m * box.length + n * box.offset;
  disk.position.y += n * box.height;
  disk.velocity.x += n * box.strain_rate * box.height;
  return disk;
}

/// Rounding of coordinates some boxes away.
double rounding(ShearedBox const& box) { return 1e-14 * std::max(box.length, box.height); }

}  // namespace

template <class Space>
class ShearedBoxOn : public testing::Test {};
TYPED_TEST_SUITE(ShearedBoxOn, EveryBackend, TypeNames);

TYPED_TEST(ShearedBoxOn, WrapTakesAnyImageBackToItsDisk) {
  for (ShearedBox const& box : boxes()) {
    std::vector<Disk> disks, images;
    for (int n : {-6, -2, -1, 0, 1, 2, 6}) {
      for (int m : {-7, -1, 0, 1, 7}) {
        for (Disk const& disk : inside(box, 50, 1)) {
          disks.push_back(disk);
          images.push_back(image(box, disk, m, n));
        }
      }
    }
    auto const back = wrapped<TypeParam>(box, images);
    for (std::size_t i = 0; i < disks.size(); ++i) {
      ASSERT_NEAR(back[i].position.x, disks[i].position.x, rounding(box));
      ASSERT_NEAR(back[i].position.y, disks[i].position.y, rounding(box));
      ASSERT_NEAR(back[i].velocity.x, disks[i].velocity.x, rounding(box));
      ASSERT_EQ(back[i].velocity.y, disks[i].velocity.y);
    }
  }
}

/// Disks at the lower edges, and at the last numbers below the upper ones, are inside.
TYPED_TEST(ShearedBoxOn, WrapKeepsTheBitsOfDisksInside) {
  for (ShearedBox const& box : boxes()) {
    auto disks = inside(box, 50, 2);
    double const right = std::nextafter(box.length, 0.0), top = std::nextafter(box.height, 0.0);
    for (double x : {0.0, 0.3 * box.length, right})
      for (double y : {0.0, 0.7 * box.height, top}) disks.push_back({{x, y}, {0.1, 0.2}});
    auto const same = wrapped<TypeParam>(box, disks);
    for (std::size_t i = 0; i < disks.size(); ++i) {
      EXPECT_EQ(same[i].position.x, disks[i].position.x);
      EXPECT_EQ(same[i].position.y, disks[i].position.y);
      EXPECT_EQ(same[i].velocity.x, disks[i].velocity.x);
    }
  }
}

/// From anywhere within several boxes: once wrapped, disks are in the box and stay as they are, and
/// each pair is at the separation and the relative velocity it had, through one image of the
/// other.
TYPED_TEST(ShearedBoxOn, WrapIsIdempotentAndKeepsPairs) {
  for (ShearedBox const& box : boxes()) {
    double const length = box.length, height = box.height;
    auto disks = inside(box, 200, 3);
    for (Disk& disk : disks) {
      disk.position.x = 9 * disk.position.x - 4 * length;
      disk.position.y = 7 * disk.position.y - 3 * height;
    }
    auto const once = wrapped<TypeParam>(box, disks);
    auto const twice = wrapped<TypeParam>(box, once);
    for (std::size_t i = 0; i < disks.size(); ++i) {
      auto const [x, y] = once[i].position;
      EXPECT_TRUE(0.0 <= x && x < length) << x;
      EXPECT_TRUE(0.0 <= y && y < height) << y;
      EXPECT_EQ(twice[i].position.x, once[i].position.x);
      EXPECT_EQ(twice[i].position.y, once[i].position.y);
      EXPECT_EQ(twice[i].velocity.x, once[i].velocity.x);
    }
    for (std::size_t i = 0, j = 1; j < disks.size(); ++i, ++j) {
      Vec2<Real> const before = disks[i].position - disks[j].position;
      Vec2<Real> const after = once[i].position - once[j].position;
      // r_ij = r_i - (r_j + image), so what the wrap added to r_i - r_j is the image's place.
      double const n = std::round((after.y - before.y) / height);
      double const m = std::round((after.x - before.x - n * box.offset) / length);
      EXPECT_NEAR(after.y - n * height, before.y, rounding(box));
      EXPECT_NEAR(after.x - n * box.offset - m * length, before.x, rounding(box));
      EXPECT_NEAR(once[i].velocity.x - once[j].velocity.x - n * box.strain_rate * height,
                  disks[i].velocity.x - disks[j].velocity.x, rounding(box));
    }
  }
}

/// x - floor(x/L) L rounds to L itself for x just below 0, and may end a rounding below 0 for x
/// just below a multiple of L; the neighbour search counts with both, and with nothing farther off.
TYPED_TEST(ShearedBoxOn, WrapBesideAnEdgeEndsWithinRoundingOfTheBox) {
  for (ShearedBox const& box : boxes()) {
    std::vector<Disk> disks;
    auto const beside = [](double edge) {
      return std::array{edge, std::nextafter(edge, -1e9), std::nextafter(edge, 1e9)};
    };
    for (int k = -5; k <= 5; ++k) {
      for (double const x : beside(k * box.length)) disks.push_back({{x, 0.5 * box.height}, {}});
      for (double const y : beside(k * box.height)) disks.push_back({{0.5 * box.length, y}, {}});
    }
    for (Disk const& disk : wrapped<TypeParam>(box, disks)) {
      EXPECT_GE(disk.position.x, -rounding(box));
      EXPECT_LE(disk.position.x, box.length);
      EXPECT_GE(disk.position.y, -rounding(box));
      EXPECT_LE(disk.position.y, box.height);
    }
  }
}

/// The place and the velocity of images, which wrap() does not use, say the same as it does.
TEST(ShearedBox, ImagesAreWhereThePapersPutThem) {
  for (ShearedBox const& box : boxes()) {
    for (int n = -1; n <= 1; ++n) {
      for (int m = -2; m <= 2; ++m) {
        Disk const expected = image(box, {}, m, n);
        EXPECT_EQ(box.shift({m, n}).x, expected.position.x);
        EXPECT_EQ(box.shift({m, n}).y, expected.position.y);
        EXPECT_NEAR(box.velocity_shift({m, n}), expected.velocity.x, rounding(box));
        EXPECT_EQ(box.shift({-m, -n}).x, -box.shift({m, n}).x);
      }
    }
  }
}

/// An image moves with the velocity with which its place does: the offset gamma L_y grows at
/// gammadot L_y.
TEST(ShearedBox, ImagesMoveAsTheirPlaceDoes) {
  double const time = 0.5;
  for (ShearedBox const& box : boxes()) {
    ShearedBox later = box;
    later.offset += box.strain_rate * box.height * time;
    for (int n = -1; n <= 1; ++n) {
      double const moved = later.shift({2, n}).x - box.shift({2, n}).x;
      EXPECT_NEAR(moved, box.velocity_shift({2, n}) * time, rounding(box));
    }
  }
}

TYPED_TEST(ShearedBoxOn, NeighborsComeOutOfTheirWordUnchanged) {
  std::vector<std::uint32_t> indices{
      0, 1, 15, 16, Neighbor::max_count / 2, Neighbor::max_count - 1};
  std::mt19937 random(4);
  for (int k = 0; k < 1000; ++k) indices.push_back(random() % Neighbor::max_count);
  EXPECT_EQ(changed_by_packing<TypeParam>(indices), 0);
}

}  // namespace bagnold::test
