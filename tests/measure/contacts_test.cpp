// SPDX-License-Identifier: BSD-3-Clause
#include "src/measure/contacts.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "kernels/observables/sums.hpp"
#include "src/config/time_step.hpp"
#include "src/simulation/observables.hpp"

namespace bagnold::test {

/// Ten disks, windows of 100 steps of 0.1 tau_e, of which the first is discarded.
class SyntheticContacts : public testing::Test {
 public:
  static constexpr int columns = SumColumns::count;
  Scene scene;
  Plan plan;
  Sampling sampling{100, 100, 300};
  Frames frames;
  OpenWindows windows;

  SyntheticContacts() {
    scene.disks.model = "CD";
    scene.disks.count = 10;
    scene.measure.contacts = true;
    scene.integration.time_step = 0.1;
    plan.time_step = 0.1;
    plan.window_steps = 100;
    plan.discarded_windows = 1;
    windows.contacts = watch_contacts(scene, plan, columns, 1, frames);
  }

  void tell(std::vector<ContactEvent> events) { windows.contacts->add(events, sampling, windows); }

  /// Of the windows from `first` on.
  double observable(std::string const& name, std::size_t first = 0) {
    windows.contacts->looked(0, 300, sampling, windows);
    std::vector<double> sums(columns + ContactColumns::count);
    for (auto w = first; w < windows.sums.size(); ++w)
      for (std::size_t c = 0; c < windows.sums[w].sums.size(); ++c)
        sums[c] += windows.sums[w].sums[c];
    for (auto const& o : observables(scene, 10.0))
      if (o.name == name) return o.value(sums);
    return NAN;
  }

  statistics::Histogram histogram(std::string const& name) const {
    for (auto const& h : Frames::join({&frames}).histograms)
      if (h.name == name) return h;
    throw std::out_of_range(name);
  }

  /// Share of what is counted in the bin that holds x.
  double share(std::string const& name, double x) const {
    auto const h = histogram(name);
    for (std::size_t b = 0; b < h.density.size(); ++b)
      if (h.edges[b] <= x && x < h.edges[b + 1])
        return h.density[b] * (h.edges[b + 1] - h.edges[b]);
    return NAN;
  }
};

TEST_F(SyntheticContacts, LastOnAverageAsLongAsTheyDid) {
  tell({{10, true, 0, 1, 0}, {50, false, 0, 1, 0}, {60, true, 2, 3, 0}, {80, false, 2, 3, 0}});
  EXPECT_NEAR(observable("tau_dur"), (4.0 + 2.0) / 2, 1e-12);
  EXPECT_NEAR(observable("nu_coll"), 2 / (10 * 2 * 30.0), 1e-12);  // `looked` has been called twice
}

/// Its whole duration counts where it ends, even if told bit by bit.
TEST_F(SyntheticContacts, ThatOutliveWindowsCountWhereTheyEnd) {
  tell({{10, true, 0, 1, 0}});
  tell({{260, false, 0, 1, 0}});
  EXPECT_NEAR(observable("tau_dur", 2), 25.0, 1e-12);
  EXPECT_EQ(windows.sums[2].sums[columns + ContactColumns::begun], 0);
  EXPECT_EQ(windows.sums[0].sums[columns + ContactColumns::begun], 1);
  EXPECT_EQ(windows.sums[1].sums[columns + ContactColumns::ended], 0);
}

TEST_F(SyntheticContacts, ThereFromTheStartHaveNoDuration) {
  tell({{0, true, 0, 1, 0}, {150, false, 0, 1, 0}, {160, true, 0, 1, 0}, {170, false, 0, 1, 0}});
  EXPECT_NEAR(observable("tau_dur"), 1.0, 1e-12);
  EXPECT_EQ(windows.sums[0].sums[columns + ContactColumns::begun], 0);
}

/// A third disk makes three contacts of many; who leaves as another comes is none.
TEST_F(SyntheticContacts, AreBinaryIfNoThirdDiskEverTouches) {
  tell({{1, true, 0, 1, 0}, {9, true, 1, 2, 0}, {11, false, 1, 2, 0}, {20, false, 0, 1, 0}});
  tell({{30, true, 3, 4, 0}, {40, false, 3, 4, 0}, {40, true, 3, 5, 0}, {50, false, 3, 5, 0}});
  tell({{60, true, 6, 7, 0}, {60, true, 7, 8, 0}, {70, false, 6, 7, 0}, {70, false, 7, 8, 0}});
  EXPECT_NEAR(observable("cluster_binary_share"), 2.0 / 6, 1e-12);
}

TEST_F(SyntheticContacts, AreCountedByAngleDurationAndClusterOnceMeasured) {
  tell({{10, true, 0, 1, 33}, {120, true, 2, 3, 179.9}, {130, true, 3, 4, -90}});
  tell({{140, false, 3, 4, 90}, {150, false, 2, 3, -1.79}, {210, false, 0, 1, 1.79}});
  EXPECT_NEAR(share("theta_begin", -180), 0.5, 1e-12);  // 179.9 is nearer to -180 than to 176.4
  EXPECT_NEAR(share("theta_begin", -90), 0.5, 1e-12);
  EXPECT_NEAR(share("theta_end", 0), 2.0 / 3, 1e-12);
  EXPECT_NEAR(share("theta_end", 90), 1.0 / 3, 1e-12);
  EXPECT_NEAR(share("theta", 0), 2.0 / 5, 1e-12);
  EXPECT_EQ(histogram("theta").edges.size(), 101u);
  EXPECT_NEAR(histogram("theta").edges[50] + 1.8, 0.0 + 0.0, 1e-9);
  EXPECT_NEAR(share("tau_dur", 20.0), 1.0 / 3, 1e-12);  // begun before it was measured, whole
  EXPECT_NEAR(share("tau_dur", 3.0), 1.0 / 3, 1e-12);
  EXPECT_NEAR(share("cluster_disks", 2), 0.5, 1e-12);
  EXPECT_NEAR(share("cluster_disks", 3), 0.5, 1e-12);
}

TEST_F(SyntheticContacts, GoOnFromWhatIsSaved) {
  std::vector<ContactEvent> const before{{110, true, 0, 1, 10}, {115, true, 1, 2, 20}};
  std::vector<ContactEvent> const after{{190, false, 0, 1, 30}, {195, false, 1, 2, 40}};
  tell(before);
  auto const saved = frames.save();
  tell(after);
  Frames again;
  auto windows_again = windows;
  windows_again.sums.clear();
  windows_again.contacts = watch_contacts(scene, plan, columns, 1, again);
  again.load(saved);
  auto rest = after;
  windows_again.contacts->add(rest, sampling, windows_again);
  EXPECT_EQ(again.save(), frames.save());
  EXPECT_EQ(windows_again.sums[1].sums[columns + ContactColumns::duration], 80 + 80);
  EXPECT_EQ(windows_again.sums[1].sums[columns + ContactColumns::binary], 0);
}

TEST_F(SyntheticContacts, RefuseWhatCannotHappen) {
  tell({{5, true, 0, 1, 0}});
  EXPECT_THROW(tell({{6, true, 1, 0, 0}}), std::logic_error);
  EXPECT_THROW(tell({{6, false, 2, 3, 0}}), std::logic_error);
}

}  // namespace bagnold::test
