// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

#include "kernels/device/contacts/detect_contacts.hpp"
#include "kernels/device/sums/add_up.hpp"
#include "src/engine/contacts/contact_record.hpp"
#include "src/engine/device_copy.hpp"

namespace bagnold {

/// Follows the contacts of one system where its disks are, on a device or not: only what begins,
/// ends or is sampled comes to the host, after one configuration or several, and is told to the
/// record while the device goes on. Plain: pair by pair of full rows, and what ContactDetector is
/// held against.
template <class Space>
class DeviceContacts {
 public:
  /// Room for that many configurations at once, from when they are first asked for.
  DeviceContacts(std::int64_t disks, std::int64_t most_steps)
      : disks_(disks), most_steps_(most_steps) {}

  /// How many of the configurations from `step` on may be looked at at once.
  std::int64_t steps(std::int64_t step, std::int64_t most, Sampling const& sampling,
                     OpenWindows const& windows) const {
    double const free = 0.5 * static_cast<double>(room());
    double const picked = pairs_of_disk * static_cast<double>(disks_) *
                          std::min(1.0, windows.contacts->picker().limit);
    double expected = 0;
    for (std::int64_t n = 0; n < most; ++n) {
      expected += changes_a_step_ + (sampling.sampled(step + n) ? picked : 0);
      if (expected > free) return std::max<std::int64_t>(n, 1);
    }
    return most;
  }

  /// Before configurations from `step` on are looked at: the record's open contacts are where the
  /// disks are, unless the last configuration before was looked at for this record.
  void begin(std::int64_t step, OpenWindows const& windows) {
    if (record_ != windows.contacts.get() || next_step_ != step) take_over(*windows.contacts);
    record_ = windows.contacts.get();
    next_step_ = step;
    first_step_ = step;
    samples_ = 0;
    Kokkos::deep_copy(found_.count, 0u);
  }

  template <class Loops, class Forces>
  void detect(Loops const& loops, Forces const& forces,
              Kokkos::View<std::uint32_t*, Space> const& original, std::int64_t step,
              Sampling const& sampling) {
    strain_rate_ = forces.box.strain_rate;
    bool const sampled = sampling.sampled(step);
    loops.for_all("contacts::DetectContacts", disks_,
                  DetectContacts<Forces, Space>{forces, original, open_, found_, record_->choice,
                                                record_->picker(), step, sampled, of_disk_});
    if (sampled) add_groups(loops, of_disk_, of_group_, totals_, samples_++);
  }

  /// Copies to the host what was found before `end`. tell() comes before the next call.
  void fetch(std::int64_t end, Sampling const& sampling) {
    untold_.motion.clear();
    if (samples_ > 0) {
      auto const totals = to_host(totals_);
      auto total = totals.begin();
      for (auto step = first_step_; step < end; ++step)
        if (sampling.sampled(step)) untold_.motion.emplace_back(step, *total++);
    }
    fetch_found();
    auto const changes = static_cast<double>(std::ranges::count_if(
        untold_.found, [](auto const& pair) { return pair.what != FoundContact::picked; }));
    constexpr double margin = 4;  // more than before
    if (end > first_step_)
      changes_a_step_ = margin * (changes + 32) / static_cast<double>(end - first_step_);
    untold_.begin = first_step_;
    untold_.end = next_step_ = end;
    untold_.strain_rate = strain_rate_;
  }

  /// Adds what was fetched to the record, once. The device may be at work meanwhile.
  void tell(Sampling const& sampling, OpenWindows& windows) {
    if (untold_.begin == untold_.end) return;
    ContactRecord& record = *windows.contacts;
    for (auto const& [step, motion] : untold_.motion) record.add(motion, step, sampling, windows);
    sort_out(record);
    record.add(picks_);
    record.add(events_, samples_of_contacts_, sampling, windows);
    record.evaluated(untold_.begin, untold_.end, sampling, windows);
    untold_.begin = untold_.end;
  }

 private:
  static constexpr double pairs_of_disk = 4;  ///< in contact, at most

  std::int64_t room() const { return static_cast<std::int64_t>(2 * pairs_of_disk) * disks_ + 1024; }

  void take_over(ContactRecord const& record) {
    auto const count = static_cast<std::size_t>(disks_);
    open_ = {
        Kokkos::View<int*, Space>("contacts::open_count", count),
        Kokkos::View<FollowedContact*, Space>("contacts::open", OpenContacts<Space>::room * count)};
    if (found_.found.extent(0) == 0) {
      found_ = {
          Kokkos::View<FoundContact*, Space>("contacts::found", static_cast<std::size_t>(room())),
          Kokkos::View<std::uint32_t*, Space>("contacts::found_count", 1)};
      of_disk_ = Row("contacts::motion_of_disk", count);
      of_group_ =
          Row("contacts::motion_of_group", static_cast<std::size_t>(groups_of_sums(disks_)));
      totals_ = Row("contacts::motion", static_cast<std::size_t>(most_steps_));
    }
    changes_a_step_ = pairs_of_disk * static_cast<double>(disks_);
    OpenContacts<Kokkos::HostSpace> const on_host{
        Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, open_.count),
        Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, open_.contacts)};
    bool all = true;
    record.table.each([&](OpenContact const& contact) {
      all = on_host.open(contact.a, {contact.b, contact.begin, contact.due}) && all;
    });
    if (!all) too_many();
    Kokkos::deep_copy(open_.count, on_host.count);
    Kokkos::deep_copy(open_.contacts, on_host.contacts);
  }

  void fetch_found() {
    std::uint32_t count = 0;
    Kokkos::deep_copy(count, Kokkos::subview(found_.count, 0));
    if (count > found_.found.extent(0)) too_many();
    untold_.found.resize(count);
    Kokkos::deep_copy(view_of(untold_.found),
                      Kokkos::View<FoundContact*, Space>(found_.found.data(), count));
  }

  /// From what was found, what the record is told; velocities are sampled last, as it wants it.
  void sort_out(ContactRecord const& record) {
    for (auto const& pair : untold_.found) {
      auto const velocities = [&] {
        return contact_velocities(pair.separation, pair.velocity, pair.spin, untold_.strain_rate);
      };
      if (pair.what & (FoundContact::begins | FoundContact::ends))
        events_.push_back(contact_event(pair.step, (pair.what & FoundContact::begins) != 0, pair.a,
                                        pair.b, pair.separation, pair.velocity));
      if (pair.what & FoundContact::sampled)
        samples_of_contacts_.push_back({pair.step, pair.a, pair.b, velocities()});
      if (pair.what & FoundContact::picked)
        picks_.push_back({record.choice.rank_at(pair.a, pair.b, pair.step), velocities()});
    }
  }

  [[noreturn]] static void too_many() {
    throw std::runtime_error("more contacts begin and end at once than there is room for");
  }

  /// Contacts found in steps begin .. end - 1.
  struct Found {
    std::int64_t begin = 0, end = 0;
    double strain_rate = 0;
    std::vector<FoundContact> found;
    std::vector<std::pair<std::int64_t, ContactMotion>> motion;  ///< by step
  };

  using Row = Kokkos::View<ContactMotion*, Space>;
  std::int64_t disks_, most_steps_;
  OpenContacts<Space> open_;
  FoundContacts<Space> found_;
  Row of_disk_, of_group_;  ///< [N], [groups_of_sums(N)], to work with
  Row totals_;              ///< of each evaluated configuration
  std::int64_t samples_ = 0;
  ContactRecord const* record_ = nullptr;
  std::int64_t first_step_ = 0, next_step_ = 0;
  double strain_rate_ = 0;
  double changes_a_step_ = 0;  ///< that are expected
  Found untold_;               ///< of which the record has not been told; empty: begin = end
  std::vector<ContactEvent> events_;
  std::vector<ContactSample> samples_of_contacts_;
  std::vector<ContactPick> picks_;
};

}  // namespace bagnold
