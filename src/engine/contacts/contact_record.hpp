// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>

#include "kernels/cpu/contacts/contact_event.hpp"
#include "src/engine/contacts/contact_columns.hpp"
#include "src/engine/contacts/contact_table.hpp"
#include "src/engine/sampling.hpp"

namespace bagnold {

/// Listener of contacts of one system that begin or end while it is measured.
class ContactListener {
 public:
  virtual ~ContactListener() = default;

  /// Called when a contact begins. cluster: disks of the connected cluster at that time, at most
  /// ContactRecord::largest_cluster.
  virtual void begins(ContactEvent const& event, std::size_t cluster) = 0;

  /// Called when a contact ends whose beginning was seen. duration: of the whole contact, [steps].
  virtual void ends(ContactEvent const& event, std::int64_t duration) = 0;

  /// Called for a sampled contact that ends, with its velocities at a random step, see
  /// SampleChoice.
  virtual void sampled(OpenContact const&) {}

  /// Whether the record counts disks of clusters; then this is called, too, for a sampled contact
  /// that ends. duration: of all of it, [steps]; cluster: disks of the connected cluster in its
  /// last configuration, at most ContactRecord::largest_cluster, as that at the random step.
  virtual bool asks_for_clusters() const { return false; }
  virtual void sampled_in_cluster(OpenContact const&, std::int64_t /*duration*/,
                                  std::size_t /*cluster*/) {}

  /// Called for contacts in evaluated configurations, in no particular order: with the sums over
  /// all of them, and with each contact whose rank is below `limit()`, see ContactPicker.
  virtual void evaluated(ContactMotion const&) {}
  virtual void picked(ContactPick const&) {}
  virtual Real limit() const { return 0; }
};

/// Turns the events of one system into sums of measurement windows.
///
/// A contact lasts from the first configuration in contact to the first one out of it, so that
/// durations add up to the contacts of all configurations. It counts as a whole in the window in
/// which it ends; its beginning counts in the window in which it begins. A contact that exists at
/// the start has no duration.
class ContactRecord {
 public:
  static constexpr std::size_t largest_cluster = 64;

  /// first_column: of ContactColumns in the windows. The listener receives events from first_step
  /// on. choice: when velocities are sampled, if at all.
  ContactRecord(std::size_t disks, int first_column, std::int64_t first_step,
                std::shared_ptr<ContactListener> listener, SampleChoice choice = {})
      : table(disks),
        choice(choice),
        first_column_(static_cast<std::size_t>(first_column)),
        first_step_(first_step),
        listener_(std::move(listener)) {}

  ContactTable table;
  SampleChoice const choice;

  /// Restores contacts that were open in a run that continues.
  void restore(std::vector<OpenContact> const& contacts);

  /// Contacts to be sampled in the configuration at `step`, whose events have been added.
  std::vector<OpenContact> due(std::int64_t step) const;

  /// Adds a sample, after the beginning of the contact and before its end.
  void add(ContactSample const& sample);

  /// Adds events of new configurations, in any order; clears them.
  void add(std::vector<ContactEvent>& events, Sampling const& sampling, OpenWindows& windows);

  /// Adds events, and the samples of contacts among them.
  void add(std::vector<ContactEvent>& events, std::vector<ContactSample>& samples,
           Sampling const& sampling, OpenWindows& windows);

  /// Adds to a column of a window.
  void add(int column, double value, std::int64_t window, OpenWindows& windows) const;

  /// Counts the evaluated configurations begin .. end - 1.
  void evaluated(std::int64_t begin, std::int64_t end, Sampling const& sampling,
                 OpenWindows& windows);

  /// Adds sums over one evaluated configuration, or several, of a window; step: of any of them.
  void add(ContactMotion const& motion, std::int64_t step, Sampling const& sampling,
           OpenWindows& windows) const;

  /// Picker of contacts of evaluated configurations, from now on; and the contacts that it picked,
  /// which are cleared.
  ContactPicker picker() const;
  void add(std::vector<ContactPick>& picks) const;

 private:
  using Events = std::vector<ContactEvent>::const_iterator;
  struct Pair {
    std::uint32_t a, b;
  };
  void open(ContactEvent const& event);
  void end(ContactEvent const& event, std::size_t cluster, std::int64_t window,
           OpenWindows& windows);
  std::vector<std::size_t> clusters_of(Events first, Events last) const;
  bool counts_clusters() const { return listener_ && listener_->asks_for_clusters(); }
  void tell_begun(Events first, Events last) const;

  std::size_t first_column_;
  std::int64_t first_step_;
  std::shared_ptr<ContactListener> listener_;      ///< or none
  std::map<std::int64_t, std::vector<Pair>> due_;  ///< by step; some may have ended since
};

}  // namespace bagnold
