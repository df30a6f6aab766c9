// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kernels/device/loops.hpp"
#include "kernels/physics/box/list_criterion.hpp"

namespace bagnold {

/// Up to which result of a reduction steps may go on: by the list, which holds up to a largest
/// |w|^2, or where the list has nothing to do with it, up to zero.
struct QueuedLimit {
  bool by_list = false;
  Real strain = 0;        ///< since the list was built
  Real skin = 0;          ///< [d_s]
  Real surely_below = 0;  ///< [d_s^2]: a result below it needs no closer look

  static QueuedLimit of_list(Real strain, Real skin) {
    Real const reach = list_reach(strain, skin);
    return {true, strain, skin, reach > 0 ? Real(0.999) * reach * reach : 0};
  }

  KOKKOS_FUNCTION bool allows(Real result) const {
    if (result < surely_below) return true;
    return by_list ? list_holds(strain, result, skin) : !(result > 0);
  }
};

/// Seen by each thread of a queued loop before it does anything.
template <class Space>
struct QueuedGuard {
  Kokkos::View<Real*, Space> results;
  std::int64_t place = -1;  ///< of the last reduction before the loop; -1: none
  QueuedLimit limit;

  KOKKOS_FUNCTION bool passes() const { return place < 0 || limit.allows(results(place)); }
};

/// Loops of several steps, launched one after the other without the host waiting between them.
/// Each looks first whether the reduction before it allows it to go on; once one does not, all
/// that come after do nothing, and their reductions say that they did nothing by the largest number
/// there is. The host reads all results at once, afterwards.
///
/// A reduction tells results beyond its limit, the largest of them, and zero where there are none:
/// threads with a smaller one have nothing to write, so it needs no pass of its own.
template <class Space>
class LaunchQueue {
 public:
  /// room: reductions that are queued at most.
  LaunchQueue(Space const& space, std::int64_t room)
      : space_(space),
        results_("device::queued_results", static_cast<std::size_t>(room)),
        on_host_(Kokkos::create_mirror_view(results_)) {}

  /// With nothing queued.
  void begin() {
    limits_.clear();
    Kokkos::deep_copy(space_, results_, Real(0));
  }

  /// Sets the limit of the reductions that are queued from now on.
  void set_limit(QueuedLimit const& limit) { limit_ = limit; }

  template <class Body>
  void for_all(char const* label, std::int64_t count, Body const& body) {
    Launches<Space>{space_}.for_all(label, count, GuardedBody<Body>{guard(), body});
  }

  /// The result stays on the device until results().
  template <class Body>
  void largest(char const* label, std::int64_t count, Body const& body) {
    auto const before = guard();
    limits_.push_back(limit_);
    Launches<Space>{space_}.for_all(label, count, GuardedLargest<Body>{before, guard(), body});
  }

  struct Result {
    Real value;
    QueuedLimit limit;
  };

  /// Results of all that was queued, in order. Waits for them.
  std::vector<Result> results() {
    Kokkos::deep_copy(space_, on_host_, results_);
    space_.fence();
    std::vector<Result> all;
    for (std::size_t k = 0; k < limits_.size(); ++k) all.push_back({on_host_(k), limits_[k]});
    return all;
  }

  // Functors are public: nvcc launches no others.

  template <class Body>
  struct GuardedBody {
    QueuedGuard<Space> guard;
    Body body;

    KOKKOS_FUNCTION void operator()(std::int64_t i) const {
      if (guard.passes()) body(static_cast<std::uint32_t>(i));
    }
  };

  template <class Body>
  struct GuardedLargest {
    QueuedGuard<Space> guard, own;
    Body body;

    KOKKOS_FUNCTION void operator()(std::int64_t i) const {
      Real result = 0;
      if (guard.passes())
        body(static_cast<std::uint32_t>(i), result);
      else
        result = Kokkos::reduction_identity<Real>::min();
      if (own.limit.allows(result)) return;
      Real& largest = own.results(own.place);
      if (result > largest) Kokkos::atomic_fetch_max(&largest, result);
    }
  };

 private:
  QueuedGuard<Space> guard() const {
    if (limits_.empty()) return {results_, -1, {}};
    return {results_, static_cast<std::int64_t>(limits_.size()) - 1, limits_.back()};
  }

  Space space_;
  Kokkos::View<Real*, Space> results_;
  typename Kokkos::View<Real*, Space>::HostMirror on_host_;
  QueuedLimit limit_;
  std::vector<QueuedLimit> limits_;  ///< of the reductions that are queued
};

/// The loops of a SteppedSystem, queued. What reductions would give the host is not known yet: it
/// stays as it was.
template <class Space>
struct QueuedLoops {
  LaunchQueue<Space>* queue;

  template <class Body>
  void for_all(char const* label, std::int64_t count, Body const& body) const {
    queue->for_all(label, count, body);
  }
  template <class Body>
  void reduce(char const* label, std::int64_t count, Body const& body,
              Kokkos::Max<Real> const&) const {
    queue->largest(label, count, body);
  }
};

}  // namespace bagnold
