// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "kernels/dynamics/contact_event.hpp"
#include "src/simulation/contact_columns.hpp"
#include "src/simulation/contact_table.hpp"
#include "src/simulation/sampling.hpp"

namespace bagnold {

/// Is told of every contact of one system that begins or ends while it is measured.
class ContactListener {
 public:
  virtual ~ContactListener() = default;

  /// cluster: disks of the connected cluster right then, at most ContactRecord::largest_cluster.
  virtual void begins(ContactEvent const& event, std::size_t cluster) = 0;

  /// Only of contacts that were seen to begin. duration: whole, [steps].
  virtual void ends(ContactEvent const& event, std::int64_t duration) = 0;
};

/// Turns the events of one system into sums of measurement windows.
///
/// A contact lasts from the first configuration in contact to the first one out of it, so that
/// durations add up to the contacts of all configurations. It counts, whole, in the window in which
/// it ends; its beginning in the window in which it begins. What was in contact at the start has no
/// duration.
class ContactRecord {
 public:
  static constexpr std::size_t largest_cluster = 64;

  /// first_column: of ContactColumns in the windows. The listener hears of events from first_step
  /// on.
  ContactRecord(std::size_t disks, int first_column, std::int64_t first_step,
                std::shared_ptr<ContactListener> listener)
      : table(disks),
        first_column_(static_cast<std::size_t>(first_column)),
        first_step_(first_step),
        listener_(std::move(listener)) {}

  ContactTable table;

  /// Events of configurations that have not been told of, in any order, which are used up.
  void add(std::vector<ContactEvent>& events, Sampling const& sampling, OpenWindows& windows);

  /// Adds to a column of a window.
  void add(int column, double value, std::int64_t window, OpenWindows& windows) const;

  /// Configurations begin .. end - 1 have been looked at.
  void looked(std::int64_t begin, std::int64_t end, Sampling const& sampling,
              OpenWindows& windows) const;

  /// Sums over one evaluated configuration, or several.
  void add(ContactMotion const& motion, std::int64_t window, OpenWindows& windows) const;

 private:
  using Events = std::vector<ContactEvent>::const_iterator;
  void end(ContactEvent const& event, std::int64_t window, OpenWindows& windows);
  void tell_begun(Events first, Events last) const;

  std::size_t first_column_;
  std::int64_t first_step_;
  std::shared_ptr<ContactListener> listener_;  ///< or none
};

}  // namespace bagnold
