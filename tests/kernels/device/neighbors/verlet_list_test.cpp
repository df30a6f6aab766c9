// SPDX-License-Identifier: BSD-3-Clause
#include "kernels/device/neighbors/verlet_list.hpp"

#include <limits>

#include "tests/kernels/device/neighbors/listed.hpp"
#include "tests/support/typed.hpp"

namespace bagnold::test {
namespace {

/// |w|^2 of one disk, and what a list says to that: in, then out.
struct Question {
  Vec2<Real> position, at_build;
  Real strain, skin;
  Real nonaffine2 = 0;
  bool holds = false;
};

KOKKOS_INLINE_FUNCTION void answer(Question& q) {
  q.nonaffine2 = nonaffine2(q.position, q.at_build, q.strain);
  q.holds = list_holds(q.strain, q.nonaffine2, q.skin);
}

template <class Space>
std::vector<Question> answered(std::vector<Question> const& questions) {
  auto const device = to_device<Space>("test::questions", questions);
  Kokkos::parallel_for(
      "test::answer", Kokkos::RangePolicy<Space>(0, questions.size()),
      KOKKOS_LAMBDA(std::int64_t k) { answer(device(k)); });
  return to_host(device);
}

/// Unlisted pairs that set out for each other.
struct Conspiracy {
  std::vector<Vec2<Real>> toward;  ///< [N], where each disk heads: a unit vector, or zero
  double nearest_gap = std::numeric_limits<double>::infinity();  ///< smallest r_ij - d_ij, [d_s]
};

/// The nearest unlisted pairs after the mean flow alone, each disk in one pair.
template <class Space>
Conspiracy conspire(Listed<Space> const& listed, double strain) {
  struct Approach {
    double gap;
    std::uint32_t i, j;
    Vec2<Real> direction;  ///< from j to i
  };
  std::vector<Vec2<Real>> const at_rest(listed.at_build.count());
  Disks const disks = listed.moved(strain, at_rest);
  double const offset = listed.offset + strain * listed.length;
  std::vector<Approach> approaches;
  Rows const near = all_pairs(disks, listed.length, offset, 2 * listed.skin);
  for (std::uint32_t i = 0; i < disks.count(); ++i) {
    for (auto const& [j, m, n] : near[i]) {
      if (listed.has(i, {j, m, n})) continue;
      Vec2<Real> const image{m * listed.length + n * offset, n * listed.length};
      Vec2<Real> const r = disks.position[i] - disks.position[j] - image;
      double const distance = std::hypot(r.x, r.y);
      double const gap = distance - (disks.diameter[i] + disks.diameter[j]) / 2;
      approaches.push_back({gap, i, j, 1 / distance * r});
    }
  }
  std::sort(approaches.begin(), approaches.end(),
            [](Approach const& a, Approach const& b) { return a.gap < b.gap; });

  Conspiracy conspiracy{at_rest};
  std::vector<bool> taken(disks.count());
  for (Approach const& a : approaches) {
    conspiracy.nearest_gap = std::min(conspiracy.nearest_gap, a.gap);
    if (taken[a.i] || taken[a.j]) continue;
    taken[a.i] = taken[a.j] = true;
    conspiracy.toward[a.i] = Real(-1) * a.direction;
    conspiracy.toward[a.j] = a.direction;
  }
  return conspiracy;
}

}  // namespace

template <class Space>
class VerletListOn : public testing::Test {};
TYPED_TEST_SUITE(VerletListOn, EveryBackend, TypeNames);

/// Disks walk at random while the box shears: as long as the list holds, it has all contacts.
TYPED_TEST(VerletListOn, HasEveryContactOfRandomWalkers) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::normal_distribution<double> normal;
  int yes = 0, no = 0;
  for (double skin : skins) {
    for (int trial = 0; trial < 40 / one_trial_in<TypeParam>(10); ++trial) {
      auto const listed = random_list<TypeParam>(skin, random);
      double const sign = trial % 2 == 0 ? 1.0 : -1.0;
      double const rate = sign * widest_strain(skin) * std::pow(unit(random), 2) / 16;
      double const step = 0.3 * unit(random) * skin / 4;
      std::vector<Vec2<Real>> w(listed.at_build.count());
      for (int k = 1; k <= 16; ++k) {
        for (auto& nonaffine : w) nonaffine += {step * normal(random), step * normal(random)};
        Disks const now = listed.moved(k * rate, w);
        double widest = 0.0;
        for (auto const& nonaffine : w)
          widest = std::max(widest, std::hypot(nonaffine.x, nonaffine.y));
        if (listed.holds(now, k * rate)) {
          ++yes;
          ASSERT_LT(2 * widest, skin);  // two disks may each come half the skin closer
          ASSERT_EQ(listed.missed(now, k * rate), 0u) << "skin " << skin << ", step " << k;
        } else {
          ++no;
        }
      }
    }
  }
  double const share = static_cast<double>(yes) / (yes + no);
  this->RecordProperty("share_of_yes", std::to_string(share));
  EXPECT_GT(share, 0.3);
  EXPECT_LT(share, 0.9);
}

/// Unlisted disks go straight for each other, each by the whole non-affine displacement allowed. At
/// half as much again the list must say no, and does miss contacts.
TYPED_TEST(VerletListOn, HasEveryContactOfDisksThatConspire) {
  std::mt19937_64 random(6);
  int yes = 0, missed_later = 0;
  double closest = std::numeric_limits<double>::infinity();
  for (double skin : skins) {
    for (int trial = 0; trial < 16 / one_trial_in<TypeParam>(8); ++trial) {
      auto const listed = random_list<TypeParam>(skin, random);
      for (double share : {-0.9, -0.5, -0.1, -1e-6, 0.0, 1e-6, 0.1, 0.5, 0.9}) {
        double const strain = share * widest_strain(skin);
        double const allowed = allowed_nonaffine(strain, skin);
        ASSERT_GT(allowed, 0.0);
        Conspiracy const conspiracy = conspire(listed, strain);
        closest = std::min(closest, conspiracy.nearest_gap / (2 * allowed));
        auto const by = [&](double nonaffine) {
          auto w = conspiracy.toward;
          for (auto& direction : w) direction = nonaffine * direction;
          return listed.moved(strain, w);
        };
        Disks const before = by(0.999999 * allowed);
        ASSERT_TRUE(listed.holds(before, strain)) << "skin " << skin << ", strain " << strain;
        ASSERT_EQ(listed.missed(before, strain), 0u) << "skin " << skin << ", strain " << strain;
        Disks const beyond = by(1.5 * allowed);
        ASSERT_FALSE(listed.holds(beyond, strain));
        missed_later += listed.missed(beyond, strain) > 0;
        ++yes;
      }
    }
  }
  this->RecordProperty("closest_gap_over_allowed", std::to_string(closest));
  EXPECT_GT(missed_later, yes / 2);
}

/// Every backend reads the criterion as the host does.
TYPED_TEST(VerletListOn, IsJudgedAlikeOnTheDevice) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  std::vector<Question> questions(1000);
  for (Question& q : questions) {
    q = {{}, {5 + 5 * any(random), 5 + 5 * any(random)}, 0.5 * any(random), 0.6};
    q.position = q.at_build + Vec2<Real>{q.strain * q.at_build.y, 0} +
                 Vec2<Real>{0.3 * any(random), 0.3 * any(random)};
  }
  auto const found = answered<TypeParam>(questions);
  int yes = 0;
  for (std::size_t k = 0; k < questions.size(); ++k) {
    answer(questions[k]);
    EXPECT_NEAR(found[k].nonaffine2, questions[k].nonaffine2, 1e-14);
    EXPECT_EQ(found[k].holds, questions[k].holds);
    yes += found[k].holds;
  }
  EXPECT_GT(yes, 200);
  EXPECT_LT(yes, 800);
}

}  // namespace bagnold::test
