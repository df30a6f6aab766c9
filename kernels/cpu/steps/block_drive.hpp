// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "kernels/cpu/steps/kick.hpp"
#include "kernels/cpu/steps/pass_of.hpp"
#include "kernels/physics/drives/drive_power.hpp"
#include "kernels/physics/drives/second_drag.hpp"
#include "kernels/physics/drives/trial_shares.hpp"
#include "kernels/physics/random.hpp"
#include "kernels/physics/sums/sums.hpp"

namespace bagnold {

/// Part of a one-body force in a step on blocks, each of them a pass. Passes of the scheme stand
/// before and after it; a scene without a drive has none.
enum class DrivePart {
  force,          ///< adds the force at `now` to the forces in the scratch
  trial_force,    ///< adds the force at the trial state, where the step ends
  second,         ///< adds the second stage: the drag of the changes that `trial` holds
  power,          ///< powers of the force, by the velocities of `now` and `trial`
  powers_of_both  ///< powers of both stages, with the velocities halfway through the step
};

/// A one-body force on the disks of blocks. Steps of all laws share it. Force: simd::Force or
/// simd::TurningForce.
template <class Force, bool Rotates>
class BlockDrive {
 public:
  virtual ~BlockDrive() = default;

  /// Pass of a part, as long as the drive lives.
  virtual std::unique_ptr<BlockPass const> pass(DrivePart part) const = 0;
};

/// BlockDrive of one drive.
template <OneBodyDrive Drive, class F, bool Rotates>
class DriveOnBlocks final : public BlockDrive<F, Rotates> {
 public:
  using Force = F;

  DriveOnBlocks(DriveInput const& input, RandomStream const& stream)
      : drive_(Drive::make(input)),
        second_(input),
        trial_shares_(input),
        time_step_(input.time_step),
        stream_(stream) {}

  std::unique_ptr<BlockPass const> pass(DrivePart part) const override {
    auto const make = [&](typename PassOf<DriveOnBlocks>::Run run, When when) {
      return std::make_unique<PassOf<DriveOnBlocks>>(*this, run,
                                                     PassFacts{.when = when, .uses = Uses::drive});
    };
    switch (part) {
      case DrivePart::force:
        return make(&DriveOnBlocks::add, When::always);
      case DrivePart::trial_force:
        return make(&DriveOnBlocks::add_at_trial, When::always);
      case DrivePart::second:
        return make(&DriveOnBlocks::add_second, When::always);
      case DrivePart::power:
        return make(&DriveOnBlocks::power, When::sampled);
      default:
        return make(&DriveOnBlocks::powers_of_both, When::sampled);
    }
  }

  BlockReport add(BlockSystem const& s, std::uint32_t b, StepAt const& at, Force* force) const {
    return add_at(s.now, s, b, at.box.strain_rate, force);
  }

  BlockReport add_at_trial(BlockSystem const& s, std::uint32_t b, StepAt const& at,
                           Force* force) const {
    return add_at(s.trial, s, b, at.next_box.strain_rate, force);
  }

  BlockReport add_second(BlockSystem const& s, std::uint32_t b, StepAt const& at,
                         Force* scratch) const {
    Block const& block = s.blocks.block(b);
    auto* const force = second_forces(s, at, scratch);
    for (std::uint32_t i = 0; i < block.own; i += simd::width) {
      auto const change = change_at(s, block, i);
      add_to(force + i, block.own - i, second_(change), change);
    }
    return {};
  }

  BlockReport power(BlockSystem const& s, std::uint32_t b, StepAt const& at, Force*) const {
    Block const& block = s.blocks.block(b);
    Real const strain_rate = at.box.strain_rate;
    at.drive_powers[b] = sum(block, strain_rate, [&](std::uint32_t i) {
      auto const disk = disk_at(s, block, s.now, i, strain_rate);
      auto const slot = block.first + i;
      auto const r = simd::load_records(s.trial.record.data() + slot);
      auto const trial = moving(s, s.trial, slot, r, disk.position.y, strain_rate);
      return Acting{drag_force(drive_.drag, trial_shares_.dragged(disk, trial)), drive_.push(disk),
                    trial_shares_.halfway(disk, trial)};
    });
    return {};
  }

  BlockReport powers_of_both(BlockSystem const& s, std::uint32_t b, StepAt const& at,
                             Force* scratch) const {
    Block const& block = s.blocks.block(b);
    Real const strain_rate = at.box.strain_rate;
    auto const* const second = second_forces(s, at, scratch);
    Kick const half(s.table, time_step_ / 2);
    at.drive_powers[b] = sum(block, strain_rate, [&](std::uint32_t i) {
      auto const disk = disk_at(s, block, s.now, i, strain_rate);
      auto const change = change_at(s, block, i);
      auto const f = simd::load_forces(second + i);
      auto const big = simd::nonzero(s.species.data() + block.first + i);
      auto halfway = disk;
      halfway.velocity =
          disk.velocity + Pack(0.5) * change.velocity + half.per_mass(big) * f.force();
      halfway.spin = disk.spin + 0.5 * change.spin + half.per_inertia(big) * f.torque_per_diameter;
      auto drag = drag_force(drive_.drag, disk);
      drag += second_(change);
      return Acting{drag, drive_.push(disk), halfway};
    });
    return {};
  }

 private:
  using Pack = simd::Pack;

  struct Acting {
    Push<Pack> drag, push;
    DrivenDisk<Pack> halfway;  ///< where velocities are those halfway through the step
  };

  BlockReport add_at(BlockState const& state, BlockSystem const& s, std::uint32_t b,
                     Real strain_rate, Force* force) const {
    Block const& block = s.blocks.block(b);
    for (std::uint32_t i = 0; i < block.own; i += simd::width) {
      auto const disk = disk_at(s, block, state, i, strain_rate);
      auto push = drag_force(drive_.drag, disk);
      push += drive_.push(disk);
      add_to(force + i, block.own - i, push, disk);
    }
    return {};
  }

  /// Powers of the own disks of a block; inert disks stay at rest. acting: drag, push and motion of
  /// a pack.
  template <class Of>
  static DrivePower sum(Block const& block, Real strain_rate, Of const& acting) {
    Pack drag = 0.0, push = 0.0;
    for (std::uint32_t i = 0; i < block.own; i += simd::width) {
      auto const own = simd::first_lanes(block.own - i);
      auto const of = acting(i);
      drag += zero_unless(own, power_of(of.drag, of.halfway, strain_rate));
      push += zero_unless(own, power_of(of.push, of.halfway, strain_rate));
    }
    return {-simd::sum(drag), simd::sum(push)};
  }

  DrivenDisk<Pack> disk_at(BlockSystem const& s, Block const& block, BlockState const& state,
                           std::uint32_t i, Real strain_rate) const {
    auto const slot = block.first + i;
    auto const r = simd::load_records(state.record.data() + slot);
    auto disk = moving(s, state, slot, r, r.y, strain_rate);
    if constexpr (Drive::random) {
      for (int k = 0; k < simd::width; ++k) {
        auto const random = stream_.centred(s.disk_of(slot + static_cast<std::uint32_t>(k)),
                                            static_cast<std::uint64_t>(s.step));
        disk.random.x.v[k] = random.x;
        disk.random.y.v[k] = random.y;
        if constexpr (Rotates) disk.random_spin.v[k] = random.z;
      }
    }
    return disk;
  }

  /// Motion of disks relative to the mean flow at their y.
  static DrivenDisk<Pack> moving(BlockSystem const& s, BlockState const& state, std::uint32_t slot,
                                 simd::Records const& r, Pack const& y, Real strain_rate) {
    DrivenDisk<Pack> disk = sized(s, slot);
    disk.position = r.position();
    disk.velocity = {peculiar_x(r.vx, y, strain_rate), r.vy};
    if constexpr (Rotates) disk.spin = Pack::load(state.spin.data() + slot) + strain_rate / 2;
    return disk;
  }

  static DrivenDisk<Pack> change_at(BlockSystem const& s, Block const& block, std::uint32_t i) {
    auto const slot = block.first + i;
    auto const change = simd::load_records(s.trial.record.data() + slot);
    DrivenDisk<Pack> disk = sized(s, slot);
    disk.velocity = change.position();
    if constexpr (Rotates) disk.spin = change.vx;
    return disk;
  }

  /// Disks at rest in the flow, with their sizes.
  static DrivenDisk<Pack> sized(BlockSystem const& s, std::uint32_t slot) {
    auto const big = simd::nonzero(s.species.data() + slot);
    return {{0.0, 0.0}, {0.0, 0.0}, 0.0, select(big, Pack(1.0), Pack(0.0)), {0.0, 0.0}, 0.0};
  }

  static void add_to(Force* force, std::uint32_t count, Push<Pack> const& push,
                     DrivenDisk<Pack> const& disk) {
    Pack torque_per_diameter = 0.0;
    if constexpr (Rotates)
      torque_per_diameter = push.torque / disk.of({small_diameter, big_diameter});
    for (std::uint32_t k = 0; k < std::min<std::uint32_t>(count, simd::width); ++k) {
      force[k].x += push.force.x.v[k];
      force[k].y += push.force.y.v[k];
      if constexpr (Rotates) force[k].torque_per_diameter += torque_per_diameter.v[k];
    }
  }

  Drive drive_;
  SecondDrag second_;
  TrialShares trial_shares_;
  Real time_step_;
  RandomStream stream_;
};

}  // namespace bagnold
