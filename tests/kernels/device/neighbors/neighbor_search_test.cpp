// SPDX-License-Identifier: BSD-3-Clause
#include <array>

#include "tests/kernels/device/neighbors/lists.hpp"
#include "tests/support/typed.hpp"

namespace bagnold::test {
namespace {

/// Rows rise by index, so that no disk is there twice; i has j's image if j has i's at the
/// opposite.
void expect_sound(Rows const& rows) {
  for (std::uint32_t i = 0; i < rows.size(); ++i) {
    for (std::size_t k = 0; k < rows[i].size(); ++k) {
      auto const [j, m, n] = rows[i][k];
      ASSERT_NE(j, i);
      ASSERT_LT(j, rows.size());
      ASSERT_TRUE(k == 0 || rows[i][k - 1].j < j) << "row " << i;
      ASSERT_EQ(std::count(rows[j].begin(), rows[j].end(), Entry{i, -m, -n}), 1)
          << "row " << i << " has " << j << " at (" << m << ", " << n << ")";
    }
  }
}

/// Offsets at a list build, in [0, L), the ends included.
std::vector<double> offsets(double length, std::mt19937_64& random) {
  std::uniform_real_distribution<double> any(0.0, length);
  return {0.0, 1e-300, 1e-14 * length, any(random), std::nextafter(length, 0.0)};
}

/// Puts one coordinate of many disks on an edge of the box, or on both of a corner: at 0, below L,
/// and where the rounding of a wrap leaves them, at L and a little below 0.
void move_to_edges(Disks& disks, ShearedBox const& box, std::mt19937_64& random) {
  auto const edge = [&](double length) {
    return std::array{0.0, std::nextafter(length, 0.0), length, -1e-14 * length}[random() % 4];
  };
  for (std::size_t i = 0; i < disks.count(); i += 2) {
    auto const where = random() % 12;
    if (where < 8) disks.position[i].x = edge(box.length);
    if (where >= 4) disks.position[i].y = edge(box.height);
  }
}

}  // namespace

template <class Space>
class NeighborSearchOn : public testing::Test {
 public:
  static void expect_all_pairs(Disks const& disks, ShearedBox const& box, double skin) {
    VerletList<Space> list;
    rebuild(list, disks, box, skin);
    Rows const rows = rows_of(list.rows);
    expect_sound(rows);
    ASSERT_EQ(difference(rows, all_pairs(disks, box, skin)), "")
        << disks.count() << " disks, " << box.length << " x " << box.height << ", offset "
        << box.offset << ", skin " << skin;
  }
};
TYPED_TEST_SUITE(NeighborSearchOn, EveryBackend, TypeNames);

/// In boxes of two cells across, where all pairs are tried, in the narrowest with cells, at widths
/// around the next cell, and wide ones. Few disks in a wide box have fewer and wider cells.
TYPED_TEST(NeighborSearchOn, RowsAreAllPairsWithinReach) {
  std::mt19937_64 random(1);
  int trial = 0;
  for (double skin : {0.05, 0.3, 1.0}) {
    double const reach = big_diameter + skin;
    for (double width : {2.0, 2.4, 2.999, 3.0, 3.001, 3.999, 4.0, 4.7, 8.3, 16.0}) {
      double const length = width == 2.0 ? narrowest(skin) : width * reach;
      for (std::size_t count : {8, 9, 27, 64, 150}) {
        for (double offset : offsets(length, random)) {
          if (trial++ % one_trial_in<TypeParam>(97) != 0) continue;
          ShearedBox const box{length, offset, 0.0};
          Disks disks = anywhere(count, box, random);
          this->expect_all_pairs(disks, box, skin);
          move_to_edges(disks, box, random);
          this->expect_all_pairs(disks, box, skin);
          if (this->HasFatalFailure()) return;
        }
      }
    }
  }
}

TYPED_TEST(NeighborSearchOn, RowsAreAllPairsOfManyDisks) {
  std::mt19937_64 random(2);
  int trial = 0;
  double const skin = 0.2;
  for (double length : {narrowest(skin), 5.5, 24.0, 60.0}) {
    for (double offset : offsets(length, random)) {
      if (trial++ % one_trial_in<TypeParam>(4) != 0) continue;
      ShearedBox const box{length, offset, 0.0};
      this->expect_all_pairs(anywhere(500, box, random), box, skin);
      if (this->HasFatalFailure()) return;
    }
  }
}

/// Tall boxes and flat ones, down to two cells one way and many the other.
TYPED_TEST(NeighborSearchOn, RowsAreAllPairsInBoxesThatAreNotSquare) {
  std::mt19937_64 random(4);
  int trial = 0;
  double const skin = 0.3, reach = big_diameter + skin;
  for (double width : {2.001, 3.001, 4.7, 11.0}) {
    for (double aspect : {4.0, 17.3, 64.0}) {
      for (bool tall : {true, false}) {
        double const shorter = width * reach, longer = aspect * shorter;
        double const length = tall ? shorter : longer;
        for (double offset : offsets(length, random)) {
          if (trial++ % one_trial_in<TypeParam>(17) != 0) continue;
          ShearedBox const box{length, offset, 0.0, tall ? longer : shorter};
          Disks disks = anywhere(300, box, random);
          this->expect_all_pairs(disks, box, skin);
          move_to_edges(disks, box, random);
          this->expect_all_pairs(disks, box, skin);
          if (this->HasFatalFailure()) return;
        }
      }
    }
  }
}

/// One list renewed again and again while disks wander over the edges and the box shears on. The
/// disks crowd and spread by turns: rows outgrow the room of an earlier build, and leave some over.
TYPED_TEST(NeighborSearchOn, RowsAreRenewedAfterMotionAndShear) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> step(0.0, 0.6);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  double const skin = 0.2;
  int const rounds = 60 / one_trial_in<TypeParam>(10);
  for (std::size_t count : {30, 90}) {
    for (double length : {5.2, 11.0}) {
      Disks disks = anywhere(count, length, random);
      VerletList<TypeParam> list;
      double offset = 0.0;
      int grown = 0, with_room_left = 0;
      for (int round = 0; round < rounds; ++round) {
        double const crowding = round % 3 == 2 ? 0.4 : 1.3;  // towards the middle, and from it
        offset = std::fmod(offset + any(random) * length, length);
        for (auto& position : disks.position) {
          position.x = length / 2 + crowding * (position.x - length / 2) + step(random);
          position.y = length / 2 + crowding * (position.y - length / 2) + step(random);
          Real unused = 0.0;
          wrap(ShearedBox{length, offset, 0.0}, position, unused);
        }
        auto const room = list.rows.entries.extent(0);
        rebuild(list, disks, length, offset, skin);
        grown += room != 0 && list.rows.entries.extent(0) > room;
        Rows const rows = rows_of(list.rows);
        expect_sound(rows);
        ASSERT_EQ(difference(rows, all_pairs(disks, length, offset, skin)), "")
            << "round " << round;
        std::size_t used = 0;
        for (auto const& row : rows) used += row.size();
        with_room_left += used < room;
      }
      EXPECT_GT(grown, 0);
      EXPECT_GT(with_room_left, rounds / 5);
    }
  }
}

}  // namespace bagnold::test
