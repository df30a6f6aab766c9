// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/engine/contacts/contact_record.hpp"
#include "src/measure/counts.hpp"
#include "src/measure/frame_observer.hpp"

namespace bagnold {

/// Edges of histograms of disks in a cluster: a bin for each number, the last one for
/// ContactRecord::largest_cluster or more.
std::vector<double> cluster_edges();

/// Histograms of contacts of one system: angles at their beginning and end, durations and clusters.
class ContactHistograms {
 public:
  /// time_step: dt, [tau_e].
  explicit ContactHistograms(double time_step);

  void begins(ContactEvent const& event, std::size_t cluster);
  void ends(ContactEvent const& event, std::int64_t duration);

  void save(ObserverState& numbers) const;
  void load(ObserverState const& numbers);

  /// Adds histograms of the same kind.
  void add(ContactHistograms const& other);

  std::vector<statistics::Histogram> histograms() const;

 private:
  double time_step_;
  Counts theta_begin_, theta_end_;  ///< [degrees], bin k centred on 3.6 k, P2 Eq. (27)
  Counts duration_;                 ///< [tau_e]
  Counts cluster_;                  ///< disks
};

}  // namespace bagnold
