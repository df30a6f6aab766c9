// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include "kernels/device/side_by_side.hpp"
#include "kernels/device/dynamics/list_renewal.hpp"
#include "kernels/device/dynamics/modified_velocity_verlet.hpp"
#include "kernels/physics/schemes/scheme.hpp"
#include "kernels/device/dynamics/two_stage_leapfrog.hpp"
#include "kernels/device/sums/measure.hpp"
#include "src/engine/in_box.hpp"
#include "src/engine/reference/row_contacts.hpp"
#include "src/engine/simulation.hpp"
#include "src/engine/state_of_views.hpp"
#include "src/engine/why_unsound.hpp"

namespace bagnold {

/// A scheme plainly: a full neighbour list, every disk sums its own contacts. What the faster engines
/// are held against.
template <ContactLaw Law, class Repulsion, class Space, Scheme Stepped>
class ReferenceEngine final : public Simulation {
 public:
  static constexpr bool rotates = Law::rotates;
  static constexpr bool two_stage = Stepped == Scheme::two_stage_leapfrog;

  /// A start: `snapshot.list_position` empty means no list yet.
  ReferenceEngine(Law law, SpeciesTable table, double strain_rate, double time_step, double skin,
                  Snapshot const& snapshot)
      : law_(law),
        table_(table),
        clock_{strain_rate, time_step, snapshot.state.box_length, snapshot.initial_offset,
               snapshot.initial_time},
        step_(snapshot.step),
        builds_(snapshot.list_builds),
        diameter_(snapshot.state.diameter) {
    State const& state = snapshot.state;
    position_ = to_device<Space>("state::position", vectors(state.position));
    motion_ = to_device<Space>("state::motion", motions<rotates>(state));
    species_ = to_device<Space>("state::species", species_of(state.diameter));
    auto const count = state.count();
    trial_position_ = Positions("dynamics::trial_position", count);
    trial_motion_ = Motions("dynamics::trial_motion", count);
    if constexpr (two_stage) {
      contacts_ = Kokkos::View<int*, Space>("dynamics::contacts", count);
      shares_ = to_device<Space>("dynamics::second_stage",
                                 std::vector{SecondStage(law, table, time_step)});
    }
    block_sums_ = Kokkos::View<Sums<rotates>*, Space>("observables::block_sums", blocks());
    list_.skin = skin;
    if (snapshot.list_position.empty()) {
      renew_list();
    } else {
      list_step_ = snapshot.list_step;
      list_.at_build =
          to_device<Space>("neighbors::at_build", vectors(snapshot.list_position));
      build_list(space_, list_, species_, table_, box_at(list_step_));
    }
  }

  int columns() const override { return Sums<rotates>::columns; }
  std::int64_t step() const override { return step_; }

  void advance(std::int64_t steps, Sampling const& sampling, OpenWindows& windows) override {
    for (auto const end = std::min(step_ + steps, sampling.last_step); step_ < end;) {
      if constexpr (two_stage) first_stage();
      if (sampling.sampled(step_)) windows.add(sampling.window(step_), measure().value, 1);
      if (windows.contacts)
        look_along_rows(forces_at(step_, position_, motion_), step_, sampling, windows);
      do_step();
    }
  }

  Snapshot snapshot() const override {
    Snapshot s;
    s.state = raw_state();
    s.list_position = pairs(to_host(list_.at_build));
    s.list_step = list_step_;
    s.step = step_;
    s.initial_offset = clock_.initial_offset;
    s.initial_time = clock_.initial_time;
    s.list_builds = builds_;
    return s;
  }

  State state() const override { return in_box(raw_state()); }

 private:
  using Positions = Kokkos::View<Vec2<Real>*, Space>;
  using Motions = Kokkos::View<Motion<rotates>*, Space>;
  using Policy = Kokkos::RangePolicy<Space, Kokkos::IndexType<std::int64_t>>;
  using Forces = ContactForces<Law, Repulsion, Space>;

  std::int64_t count() const { return static_cast<std::int64_t>(position_.extent(0)); }
  std::int64_t blocks() const {
    return (count() + measured_block - 1) / measured_block;
  }

  ShearedBox box_at(std::int64_t step) const {
    return {clock_.box_length, clock_.offset(step, list_step_), clock_.strain_rate};
  }

  Forces forces_at(std::int64_t step, Positions const& position, Motions const& motion) const {
    return {position, motion, species_, list_.rows, table_, box_at(step), law_, Repulsion{}};
  }

  /// The first stage of a two-stage step; the changes are in trial_motion_.
  void first_stage() {
    Real failed = 0;
    side_by_side::parallel_reduce(
        "dynamics::FirstStage", Policy(space_, 0, count()),
        FirstStage<Law, Repulsion, Space>{forces_at(step_, position_, motion_), clock_.time_step,
                                         trial_motion_, contacts_},
        Kokkos::Max<Real>(failed));
    if (failed > 0)
      why_unsound(space_, forces_at(step_, position_, motion_), clock_, step_, raw_state());
  }

  ChangeForces<Law, Repulsion, Space> change_forces() const {
    return {forces_at(step_, position_, motion_), trial_motion_, contacts_, shares_,
            clock_.time_step};
  }

  void do_step() {
    double const strain = clock_.strain_between(list_step_, step_ + 1);
    double const next_strain = clock_.strain_between(list_step_, step_ + 2);
    Real largest2 = 0;
    if constexpr (two_stage) {
      side_by_side::parallel_reduce(
          "dynamics::LeapOn", Policy(space_, 0, count()),
          LeapOn<Law, Repulsion, Space>{change_forces(), clock_.time_step, trial_position_, motion_,
                                        list_.at_build, strain, next_strain},
          Kokkos::Max<Real>(largest2));
      std::swap(position_, trial_position_);
    } else {
      side_by_side::parallel_for(
          "dynamics::Predict", Policy(space_, 0, count()),
          Predict<Law, Repulsion, Space>{forces_at(step_, position_, motion_), clock_.time_step,
                                         trial_position_, trial_motion_});
      side_by_side::parallel_reduce(
          "dynamics::Correct", Policy(space_, 0, count()),
          Correct<Law, Repulsion, Space>{forces_at(step_ + 1, trial_position_, trial_motion_),
                                         clock_.time_step, position_, motion_, list_.at_build,
                                         strain, next_strain},
          Kokkos::Max<Real>(largest2));
    }
    ++step_;
    if (largest2 == std::numeric_limits<Real>::max())
      why_unsound(space_, forces_at(step_, position_, motion_), clock_, step_, raw_state());
    double const widest = std::max(std::abs(strain), std::abs(next_strain));
    if (!list_holds(widest, largest2, list_.skin)) renew_list();
  }

  /// Take the disks into the box, build the list, and see that the next step stays within it.
  void renew_list() {
    list_step_ = step_;
    side_by_side::parallel_for("dynamics::WrapDisks", Policy(space_, 0, count()),
                         WrapDisks<rotates, Space>{box_at(step_), position_, motion_});
    if (list_.at_build.extent(0) == 0) list_.at_build = Positions("neighbors::at_build", count());
    Kokkos::deep_copy(space_, list_.at_build, position_);
    build_list(space_, list_, species_, table_, box_at(step_));
    ++builds_;

    Kokkos::MaxLoc<Real, std::int64_t>::value_type farthest{};
    double const strain = clock_.strain_between(step_, step_ + 1);
    side_by_side::parallel_reduce("dynamics::NextStep", Policy(space_, 0, count()),
                            NextStep<rotates, Space>{position_, motion_, clock_.time_step, strain},
                            Kokkos::MaxLoc<Real, std::int64_t>(farthest));
    if (!list_holds(std::abs(strain), farthest.val, list_.skin))
      failure::too_fast(clock_, step_, static_cast<std::size_t>(farthest.loc),
                        std::sqrt(farthest.val), list_.skin);
  }

  Sums<rotates> measure() {
    if constexpr (two_stage)
      measure_with(change_forces());
    else
      measure_with(forces_at(step_, position_, motion_));
    Sums<rotates> total;
    for (auto const& block : to_host(block_sums_)) total += block;
    return total;
  }

  template <class SomeForces>
  void measure_with(SomeForces const& forces) {
    side_by_side::parallel_for("observables::MeasureBlock", Policy(space_, 0, blocks()),
                               MeasureBlock<SomeForces, Space>{forces, block_sums_});
  }

  State raw_state() const {
    return state_of_views(position_, motion_, diameter_, clock_, step_);
  }

  Space space_{};
  Law law_;
  SpeciesTable table_;
  Clock clock_;
  std::int64_t step_ = 0;
  std::int64_t list_step_ = 0;
  std::int64_t builds_ = 0;
  std::vector<double> diameter_;  ///< kept on the host: files have it, steps do not need it

  Positions position_;
  Motions motion_;
  Kokkos::View<Species*, Space> species_;
  Positions trial_position_;
  Motions trial_motion_;  ///< two-stage: what the first stage changes
  Kokkos::View<int*, Space> contacts_;  ///< two-stage: of each disk
  Kokkos::View<SecondStage*, Space> shares_;  ///< two-stage: [1]
  VerletList<Space> list_;
  Kokkos::View<Sums<rotates>*, Space> block_sums_;
};

}  // namespace bagnold
