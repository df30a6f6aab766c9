// SPDX-License-Identifier: BSD-3-Clause
#include "src/measure/contacts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "kernels/physics/sums/sums.hpp"
#include "src/config/time_step.hpp"
#include "src/measure/observables.hpp"

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
    windows.contacts->evaluated(0, 300, sampling, windows);
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
  EXPECT_NEAR(observable("nu_coll"), 2 / (10 * 2 * 30.0),
              1e-12);  // `evaluated` has been called twice
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

/// Of two kinds of disks that rotate, velocities in contact at a rate of 1/2.
class SyntheticVelocities : public SyntheticContacts {
 public:
  static constexpr int columns = SumColumns::count_rotating;

  SyntheticVelocities() {
    scene.disks.model = "CD_rot";
    scene.measure.correlations = true;
    scene.shear.strain_rate = 0.5;
    frames = Frames();
    windows.contacts = watch_contacts(scene, plan, columns, 1, frames);
  }

  /// A pair one above the other that rotates, V_R = v_r / (gammadot d_s), and moves.
  static ContactMotion motion(Real v_t, Real v_r, Real v_n) {
    ContactMotion sums;
    sums.add(1, {0, -1}, {-v_t, v_n}, v_r);
    return sums;
  }

  std::vector<double> rows(Frames const& of, std::string const& name) const {
    for (auto const& table : Frames::join({&of}).samples)
      if (table.name == name) return table.rows;
    throw std::out_of_range(name);
  }
};

TEST_F(SyntheticVelocities, AreAveragedOverContactsInTime) {
  for (auto const& [v_t, v_r, v_n] :
       {std::tuple{1.0, -2.0, 3.0}, {2.0, -2.5, 1.0}, {6.0, -9.0, 2.0}})
    windows.contacts->add(motion(v_t, v_r, v_n), 200, sampling, windows);
  windows.sums[2].sums[SumColumns::contacts] = 6;
  auto const sums = windows.sums[2].sums;
  auto const value = [&](std::string const& name) {
    for (auto const& o : observables(scene, 10.0))
      if (o.name == name) return o.value(sums);
    return double(NAN);
  };
  EXPECT_NEAR(value("v_T_rms"), std::sqrt(41 / 3.0), 1e-12);
  EXPECT_NEAR(value("v_N_rms"), std::sqrt(14 / 3.0), 1e-12);
  EXPECT_NEAR(value("v_R_rms"), std::sqrt((4 + 6.25 + 81) / 3), 1e-12);
  EXPECT_NEAR(value("v_C_T_rms"), std::sqrt((1 + 0.25 + 9) / 3), 1e-12);
  // V^C_T = -1, -0.5, -3 and V^R = -2, -2.5, -9: means -1.5 and -4.5
  double const both = 0.5 * 2.5 + 1 * 2 + 1.5 * 4.5;
  double const slip2 = 0.25 + 1 + 2.25, turn2 = 6.25 + 4 + 20.25;
  EXPECT_NEAR(value("contact_rotation_correlation"), both / std::sqrt(slip2 * turn2), 1e-12);
}

/// From the first measured step on, over gammadot d_s; a run that goes on has them all, and systems
/// are taken together.
TEST_F(SyntheticVelocities, AreReportedOfAllMeasuredConfigurations) {
  auto const tell_some = [&](std::shared_ptr<ContactRecord> const& to) {
    std::vector<ContactPick> picks{{0.25, {1, -2, 3}}, {0.5, {2, -2.5, 1}}};
    to->add(motion(1, -2, 3), 100, sampling, windows);
    to->add(picks);
    EXPECT_TRUE(picks.empty());
  };
  windows.contacts->add(motion(100, 100, 100), 99, sampling, windows);
  tell_some(windows.contacts);
  auto const saved = frames.save();
  windows.contacts->add(motion(3, -1, 1), 200, sampling, windows);
  EXPECT_EQ(rows(frames, "contact_velocities"),
            (std::vector<double>{1, -2, -1, 3, 2, -2.5, -0.5, 1}));
  EXPECT_EQ(rows(frames, "contact_velocities_mean"), (std::vector<double>{4, -3, 1, 4}));
  EXPECT_NEAR(rows(frames, "contact_velocities_covariance")[4 * 0 + 2], 2 * 3, 1e-12);

  Frames again;
  auto const record = watch_contacts(scene, plan, columns, 1, again);
  again.load(saved);
  record->add(motion(3, -1, 1), 200, sampling, windows);
  EXPECT_EQ(again.save(), frames.save());

  Frames other;
  tell_some(watch_contacts(scene, plan, columns, 2, other));
  for (auto const& table : Frames::join({&frames, &other}).samples)
    if (table.name == "contact_velocities_mean") {
      EXPECT_NEAR(table.rows[0], 2 * (1 + 3 + 1) / 3.0, 1e-12);
    }
}

/// Each collision counts once, with the velocities of its last sample.
TEST_F(SyntheticVelocities, OfCollisionsAreACollisionEach) {
  std::vector<ContactEvent> events{
      {110, true, 0, 1, 0}, {110, true, 2, 3, 0}, {150, false, 0, 1, 0}, {120, false, 2, 3, 0}};
  std::vector<ContactSample> samples{{110, 0, 1, {1, 2, 3}}, {110, 2, 3, {4, 5, 6}}};
  windows.contacts->add(events, samples, sampling, windows);
  EXPECT_EQ(rows(frames, "collision_velocities").size(), 8u);
  EXPECT_EQ(rows(frames, "collision_velocities_mean"), (std::vector<double>{2.5, 3.5, 6, 4.5}));
  EXPECT_THROW(rows(frames, "contact_velocities"), std::out_of_range);
}

/// By the cluster of the last configuration, each contact once; and by that at the sample, weighted
/// by durations. Who leaves as another comes belongs to the cluster that was.
TEST_F(SyntheticVelocities, AreSortedByClusters) {
  scene.measure.clusters = true;
  frames = Frames();
  windows.contacts = watch_contacts(scene, plan, columns, 1, frames);
  auto const tell_begins = [&](std::shared_ptr<ContactRecord> const& to) {
    std::vector<ContactEvent> events{{110, true, 0, 1, 0}, {120, true, 1, 2, 0}};
    std::vector<ContactSample> samples{{110, 0, 1, {1, 2, 3}}, {120, 1, 2, {4, 5, 6}}};
    to->add(events, samples, sampling, windows);
  };
  auto const tell_ends = [&](std::shared_ptr<ContactRecord> const& to) {
    std::vector<ContactEvent> events{
        {150, false, 0, 1, 0}, {150, true, 2, 3, 0}, {160, false, 1, 2, 0}};
    std::vector<ContactSample> samples{{150, 2, 3, {0, 0, 0}}};
    to->add(events, samples, sampling, windows);
  };
  tell_begins(windows.contacts);
  auto const saved = frames.save();
  tell_ends(windows.contacts);
  EXPECT_NEAR(share("cluster_disks_end", 3), 1, 1e-12);
  auto const once = rows(frames, "collision_clusters");
  auto const in_time = rows(frames, "contact_clusters");
  constexpr std::size_t row = 7;
  EXPECT_EQ(once[0], 2);
  EXPECT_EQ(once[row], 3);
  EXPECT_EQ(once[row + 1], 2);  // both ended in a cluster of three
  EXPECT_NEAR(once[row + 3], std::sqrt((9 + 36) / 2.0), 1e-12);
  EXPECT_NEAR(once[row + 6], std::sqrt((9 + 81) / 2.0), 1e-12);
  EXPECT_EQ(in_time[1], 1);  // 0 with 1 was sampled alone
  EXPECT_NEAR(in_time[2], 0.5, 1e-12);
  EXPECT_NEAR(in_time[3], 3, 1e-12);
  EXPECT_NEAR(in_time[row + 4], 4, 1e-12);

  Frames again;
  auto const record = watch_contacts(scene, plan, columns, 1, again);
  again.load(saved);
  tell_ends(record);
  EXPECT_EQ(again.save(), frames.save());
  Frames other;
  auto const second = watch_contacts(scene, plan, columns, 2, other);
  tell_begins(second);
  tell_ends(second);
  for (auto const& table : Frames::join({&frames, &other}).samples)
    if (table.name == "collision_clusters") {
      EXPECT_EQ(table.rows[row + 1], 4);
    }
}

TEST_F(SyntheticContacts, RefuseWhatCannotHappen) {
  tell({{5, true, 0, 1, 0}});
  EXPECT_THROW(tell({{6, true, 1, 0, 0}}), std::logic_error);
  EXPECT_THROW(tell({{6, false, 2, 3, 0}}), std::logic_error);
}

}  // namespace bagnold::test
