// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <limits>

#include "src/engine/backends.hpp"
#include "src/engine/download_state.hpp"
#include "src/engine/ensemble/advance_systems.hpp"
#include "src/engine/ensemble/ensemble.hpp"
#include "src/engine/run_clock.hpp"
#include "src/engine/throw_unsound.hpp"
#include "src/engine/wrap_state.hpp"

namespace bagnold {

/// Many small systems, stepped by launches that contain the time loop, lists and samples included.
/// The host is needed only where a launch ends, where its memory for samples is full, or a list has
/// outgrown its memory. The bits of each system are those of ReferenceEngine on the same backend.
template <ContactLaw Law, class Repulsion, class Space, class Scheme>
class EnsembleEngine final : public Ensemble {
 public:
  static constexpr bool rotates = Law::rotates;

  /// Systems of equally many disks, at the same strain rates; threads of a team: 0 chooses.
  EnsembleEngine(Law law, SpeciesTable table, StrainRates const& rates, double time_step,
                 double skin, std::vector<Snapshot> const& snapshots, int threads = 0)
      : rules_{law, table, skin},
        threads_(threads),
        disks_(snapshots.front().state.count()),
        views_(snapshots.size(), disks_) {
    views_.step.allocate(law, table, time_step, snapshots.size(), disks_);
    std::size_t most_cells = 0;
    for (auto const& snapshot : snapshots) {
      add(snapshot, {rates, time_step, snapshot});
      auto const& of = constants_.back();
      most_cells = std::max(most_cells, static_cast<std::size_t>(of.columns) * of.rows);
    }
    views_.make_cells(most_cells);
    views_.make_entries(8 * disks_);  // grows where that is too little
    device_constants_ = to_device<Space>("state::constants", constants_);
    device_progress_ = to_device<Space>("state::progress", progress_);
    pending_.resize(systems());
    advance(std::numeric_limits<std::int64_t>::min(), {});  // for the lists
  }

  std::size_t systems() const override { return progress_.size(); }
  int columns() const override { return Sums<rotates>::columns; }
  std::int64_t step(std::size_t system) const override { return progress_[system].step; }

  void advance(std::int64_t end, Sampling const& sampling) override {
    while (std::any_of(progress_.begin(), progress_.end(), [&](auto const& p) {
      return p.wait == Wait::none && (p.step < end || p.list != List::stands || p.factor != 1);
    })) {
      auto const before = progress_;
      launch(end, sampling);
      take_samples_from_device(before, sampling);
      make_room();
      change_rates();
    }
  }

  void take_samples(std::size_t system, OpenWindows& windows) override {
    for (auto const& [window, sums] : pending_[system]) windows.add(window, sums.value, 1);
    pending_[system].clear();
    auto const& p = progress_[system];
    Clock const& clock = clocks_[system];
    if (p.wait == Wait::unsound)
      throw_unsound(space_, forces(system), clock, p.step, raw_state(system));
    if (p.wait == Wait::too_fast)
      failure::too_fast(clock, p.step, static_cast<std::size_t>(p.farthest.loc),
                        std::sqrt(p.farthest.val), rules_.skin);
  }

  Snapshot snapshot(std::size_t system) const override {
    auto const& p = progress_[system];
    Snapshot s = clocks_[system].snapshot(p.step, p.list_mark.step, p.list_builds);
    s.state = raw_state(system);
    s.list_position = pairs(to_host(part(views_.at_build, system)));
    return s;
  }

  State state(std::size_t system) const override { return wrap_state(raw_state(system)); }

 private:
  using Views = EnsembleViews<rotates, Space, Scheme>;
  using Kernel = AdvanceSystems<Law, Repulsion, Space, Scheme>;
  using Wait = SystemProgress::Wait;
  using List = SystemProgress::List;

  /// Sums of a sampled configuration that its system has not returned yet.
  struct Sample {
    std::int64_t window;
    Sums<rotates> sums;
  };

  void add(Snapshot const& snapshot, RunClock const& clock) {
    State const& state = snapshot.state;
    std::size_t const s = progress_.size();
    Kokkos::deep_copy(part(views_.position, s), view_of(vectors(state.position)));
    Kokkos::deep_copy(part(views_.motion, s), view_of(motions<rotates>(state)));
    Kokkos::deep_copy(part(views_.species, s), view_of(species_of(state.diameter)));
    auto const grid = empty_cell_grid<Space>(clock.box({}), big_diameter + rules_.skin,
                                             static_cast<std::int64_t>(disks_));
    clocks_.push_back(clock);
    constants_.push_back({clock, clock.rate_end, grid.columns, grid.rows});
    SystemProgress progress;
    progress.step = snapshot.step;
    progress.list_builds = snapshot.list_builds;
    if (!snapshot.list_position.empty()) {
      progress.list_mark = clock.at(snapshot.list_step).mark(snapshot.list_step);
      progress.list = List::missing;
      Kokkos::deep_copy(part(views_.at_build, s), view_of(vectors(snapshot.list_position)));
    }
    progress_.push_back(progress);
    diameter_.push_back(state.diameter);
  }

  void launch(std::int64_t end, Sampling const& sampling) {
    using Policy = typename Kernel::Policy;
    auto const scratch = Kernel::scratch_size(disks_);
    bool const in_scratch = scratch <= static_cast<std::size_t>(Policy::scratch_size_max(0));
    Kernel const kernel{views_, device_constants_, device_progress_, rules_, sampling,
                        end,    in_scratch};
    auto const policy_of = [&](int threads) {
      Policy policy(space_, static_cast<int>(systems()), threads);
      if (in_scratch) policy.set_scratch_size(0, Kokkos::PerTeam(scratch));
      return policy;
    };
    Kokkos::deep_copy(space_, device_progress_, view_of(std::as_const(progress_)));
    Kokkos::parallel_for("simulation::AdvanceSystems",
                         policy_of(threads_of_team(policy_of(1), kernel)), kernel);
    Kokkos::deep_copy(space_, view_of(progress_), device_progress_);
    space_.fence();
  }

  /// Team size on a device: the number, of those possible, for which each thread has equally many
  /// disks.
  template <class Policy>
  int threads_of_team(Policy const& policy, Kernel const& kernel) const {
    if (threads_ > 0) return threads_;
    if constexpr (!is_device<Space>) return 1;
    constexpr int warp = 32;
    int const most = policy.team_size_max(kernel, Kokkos::ParallelForTag{}) / warp * warp;
    int const disks = static_cast<int>(disks_), turns = (disks + most - 1) / most;
    return (disks + turns * warp - 1) / (turns * warp) * warp;
  }

  void take_samples_from_device(std::vector<SystemProgress> const& before,
                                Sampling const& sampling) {
    if (std::ranges::all_of(progress_, [](auto const& p) { return p.samples == 0; })) return;
    auto const& table = views_.samples;  // all systems in one copy
    auto const sums = to_host(Kokkos::View<Sums<rotates>*, Space>(table.data(), table.size()));
    for (std::size_t s = 0; s < systems(); ++s) {
      auto& p = progress_[s];
      auto at = sampling.next(before[s].step);
      auto const* of_system = sums.data() + s * table.extent(1);
      for (std::int32_t k = 0; k < p.samples; ++k, at = sampling.next(at + 1))
        pending_[s].push_back({sampling.window(at), of_system[k]});
      p.samples = 0;
      if (p.wait == Wait::for_samples) p.wait = Wait::none;
    }
  }

  /// Allocates longer lists; all lists are then built again.
  void make_room() {
    std::size_t most = 0;
    for (auto& p : progress_)
      if (p.wait == Wait::for_entries) {
        most = std::max<std::size_t>(most, p.entries);
        p.wait = Wait::none;
      }
    if (most == 0) return;
    views_.make_entries(most + most / 8);
    for (auto& p : progress_)
      if (p.list == List::stands) p.list = List::missing;
  }

  /// Moves systems whose steps at one strain rate are done to the next rate.
  void change_rates() {
    bool any = false;
    for (std::size_t s = 0; s < systems(); ++s) {
      auto& clock = clocks_[s];
      if (progress_[s].wait != Wait::none || progress_[s].step != clock.rate_end) continue;
      progress_[s].factor = clock.change_rate().factor;  // of ramps alone
      constants_[s].clock = clock;
      constants_[s].rate_end = clock.rate_end;
      any = true;
    }
    if (any) Kokkos::deep_copy(device_constants_, view_of(std::as_const(constants_)));
  }

  ContactForces<Law, Repulsion, Space> forces(std::size_t system) const {
    auto const of = views_.of(system);
    auto const& p = progress_[system];
    ShearedBox const box = clocks_[system].box(p.step, p.list_mark);
    auto const& disks = of.disks;
    return {disks.position, disks.motion, disks.species, disks.neighbors,
            rules_.table,   box,          rules_.law,    Repulsion{}};
  }

  State raw_state(std::size_t system) const {
    return state_of<rotates>(to_host(part(views_.position, system)),
                             to_host(part(views_.motion, system)), diameter_[system],
                             clocks_[system], progress_[system].step);
  }

  Space space_{};
  EnsembleRules<Law> rules_;
  int threads_;
  std::size_t disks_;  ///< of a system
  Views views_;
  std::vector<RunClock> clocks_;               ///< [S]
  std::vector<SystemConstants> constants_;     ///< [S]
  std::vector<SystemProgress> progress_;       ///< [S]
  std::vector<std::vector<double>> diameter_;  ///< [S][N]: files have it, steps do not need it
  std::vector<std::vector<Sample>> pending_;   ///< [S]
  Kokkos::View<SystemConstants*, Space> device_constants_;
  Kokkos::View<SystemProgress*, Space> device_progress_;
};

}  // namespace bagnold
