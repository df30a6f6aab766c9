// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cpu/steps/block_system.hpp"
#include "kernels/cpu/steps/kick.hpp"
#include "kernels/physics/drives/drive_power.hpp"
#include "kernels/physics/drives/second_drag.hpp"
#include "kernels/physics/random.hpp"
#include "kernels/physics/sums/sums.hpp"

namespace bagnold {

/// A one-body force on the disks of a block, behind one virtual call a block. Steps of all laws
/// share it; a scene without a drive has none. Force: simd::Force or simd::TurningForce.
template <class Force, bool Rotates>
class BlockDrive {
 public:
  virtual ~BlockDrive() = default;

  /// Adds the one-body force at a state, `now` or the trial state, to force [padded].
  virtual void add(BlockSystem const& system, Block const& block, BlockState const& state,
                   Real strain_rate, Force* force) const = 0;

  /// Adds the second stage: the drag of the changes that `trial` holds.
  virtual void add_second(BlockSystem const& system, Block const& block, Force* force) const = 0;

  /// Powers of the force at `now`, with the mean of the velocities of `now` and of the trial state.
  virtual DrivePower power(BlockSystem const& system, Block const& block,
                           Real strain_rate) const = 0;

  /// Powers of both stages, with the velocities halfway through the step. second: all forces of the
  /// second stage.
  virtual DrivePower power(BlockSystem const& system, Block const& block, Real strain_rate,
                           Force const* second) const = 0;
};

/// BlockDrive of one drive.
template <OneBodyDrive Drive, class Force, bool Rotates>
class DriveOnBlocks final : public BlockDrive<Force, Rotates> {
 public:
  DriveOnBlocks(DriveInput const& input, RandomStream const& stream)
      : drive_(Drive::make(input)), second_(input), time_step_(input.time_step), stream_(stream) {}

  void add(BlockSystem const& s, Block const& block, BlockState const& state, Real strain_rate,
           Force* force) const override {
    for (std::uint32_t i = 0; i < block.own; i += simd::width) {
      auto const disk = disk_at(s, block, state, i, strain_rate);
      auto push = drag_force(drive_.drag, disk);
      push += drive_.push(disk);
      add_to(force + i, block.own - i, push, disk);
    }
  }

  void add_second(BlockSystem const& s, Block const& block, Force* force) const override {
    for (std::uint32_t i = 0; i < block.own; i += simd::width) {
      auto const change = change_at(s, block, i);
      add_to(force + i, block.own - i, second_(change), change);
    }
  }

  DrivePower power(BlockSystem const& s, Block const& block, Real strain_rate) const override {
    return sum(block, strain_rate, [&](std::uint32_t i) {
      auto const disk = disk_at(s, block, s.now, i, strain_rate);
      auto const slot = block.first + i;
      auto const r = simd::load_records(s.trial.record.data() + slot);
      auto const trial = moving(s, s.trial, slot, r, disk.position.y, strain_rate);
      auto halfway = disk;
      halfway.velocity = Pack(0.5) * (disk.velocity + trial.velocity);
      halfway.spin = 0.5 * (disk.spin + trial.spin);
      return Acting{drag_force(drive_.drag, disk), drive_.push(disk), halfway};
    });
  }

  DrivePower power(BlockSystem const& s, Block const& block, Real strain_rate,
                   Force const* second) const override {
    Kick const half(s.table, time_step_ / 2);
    return sum(block, strain_rate, [&](std::uint32_t i) {
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
  }

 private:
  using Pack = simd::Pack;

  struct Acting {
    Push<Pack> drag, push;
    DrivenDisk<Pack> halfway;  ///< where velocities are those halfway through the step
  };

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
  Real time_step_;
  RandomStream stream_;
};

}  // namespace bagnold
