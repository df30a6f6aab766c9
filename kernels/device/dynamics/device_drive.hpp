// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Core.hpp>

#include "kernels/device/loops.hpp"
#include "kernels/physics/drives/drive_power.hpp"
#include "kernels/physics/drives/second_drag.hpp"
#include "kernels/physics/drives/trial_shares.hpp"
#include "kernels/physics/motion.hpp"
#include "kernels/physics/random.hpp"
#include "kernels/physics/sums/sums.hpp"

namespace bagnold {

/// Disks that a drive acts on, at one time.
template <bool Rotates, class Space>
struct DrivenViews {
  Kokkos::View<Vec2<Real> const*, Space> position;     ///< [N], [d_s]
  Kokkos::View<Motion<Rotates> const*, Space> motion;  ///< [N]
  Kokkos::View<Species const*, Space> species;         ///< [N]
  Real strain_rate;                                    ///< gammadot, [1 / tau_e]
  std::int64_t step;

  KOKKOS_FUNCTION DrivenDisk<Real> operator()(std::int64_t i) const { return moving(motion(i), i); }

  /// Disk i where it is, moving like this.
  KOKKOS_FUNCTION DrivenDisk<Real> moving(Motion<Rotates> const& moves, std::int64_t i) const {
    DrivenDisk<Real> disk = sized(i);
    disk.position = position(i);
    disk.velocity = {peculiar_x(moves.velocity.x, disk.position.y, strain_rate), moves.velocity.y};
    if constexpr (Rotates) disk.spin = moves.spin + strain_rate / 2;
    return disk;
  }

  /// Disk i as a drive sees it, with what a step changes.
  KOKKOS_FUNCTION DrivenDisk<Real> of(Motion<Rotates> const& change, std::int64_t i) const {
    DrivenDisk<Real> disk = sized(i);
    disk.velocity = change.velocity;
    if constexpr (Rotates) disk.spin = change.spin;
    return disk;
  }

  KOKKOS_FUNCTION DrivenDisk<Real> sized(std::int64_t i) const {
    return {{}, {}, 0, static_cast<Real>(species(i)), {}, 0};
  }
};

/// A one-body force on a device, beside the launches of a scheme's step, in launches of its own.
template <bool Rotates, class Space>
class DeviceDrive {
 public:
  using Disks = DrivenViews<Rotates, Space>;
  using Motions = Kokkos::View<Motion<Rotates>*, Space>;
  using Positions = Kokkos::View<Vec2<Real>*, Space>;

  virtual ~DeviceDrive() = default;

  /// Adds what acts on disks in dt to `to`: the trial motion, or what the first stage changes.
  virtual void kick(Space const& space, Disks const& disks, Motions const& to) const = 0;

  /// Adds the drag of the changes to the motion that the second stage goes on from.
  virtual void kick_changes(Space const& space, Disks const& disks, Motions const& change,
                            Motions const& motion) const = 0;

  /// Adds what acts on the trial state to the new one.
  virtual void kick_correction(Space const& space, Disks const& trial, Motions const& motion,
                               Positions const& position) const = 0;

  /// Powers at the velocities halfway from the disks' motion to `after`, with `change` of the first
  /// stage, whose drag acts too; or, without `change`, `after` is the trial motion.
  virtual DrivePower power(Space const& space, Disks const& disks, Motions const& after,
                           Motions const& change) const = 0;
};

/// One kind of drive on a device.
template <OneBodyDrive Drive, bool Rotates, class Space>
class DriveOnDevice final : public DeviceDrive<Rotates, Space> {
 public:
  using typename DeviceDrive<Rotates, Space>::Disks;
  using typename DeviceDrive<Rotates, Space>::Motions;
  using typename DeviceDrive<Rotates, Space>::Positions;

  DriveOnDevice(DriveInput const& input, RandomStream const& stream)
      : force_{Drive::make(input), stream},
        second_(input),
        trial_shares_(input),
        kick_{input.table, input.time_step},
        scheme_(input.scheme) {}

  void kick(Space const& space, Disks const& disks, Motions const& to) const override {
    for_all(space, "dynamics::DriveKick", disks,
            KickDisk{disks, force_, kick_.times(scheme_.trial), to});
  }

  void kick_changes(Space const& space, Disks const& disks, Motions const& change,
                    Motions const& motion) const override {
    for_all(space, "dynamics::DriveKickChanges", disks,
            KickChange{disks, second_, kick_, change, motion});
  }

  void kick_correction(Space const& space, Disks const& trial, Motions const& motion,
                       Positions const& position) const override {
    for_all(space, "dynamics::DriveKickCorrection", trial,
            KickCorrection{trial, force_, kick_.times(scheme_.velocity),
                           scheme_.position * kick_.time_step, motion, position});
  }

  DrivePower power(Space const& space, Disks const& disks, Motions const& after,
                   Motions const& change) const override {
    Kokkos::View<DrivePower*, Space> const of_disk("dynamics::drive_power",
                                                   disks.species.extent(0));
    for_all(space, "dynamics::DrivePower", disks,
            PowerOfDisk{disks, force_, second_, trial_shares_, after, change, of_disk});
    auto const on_host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), of_disk);
    DrivePower total;
    for (std::size_t i = 0; i < on_host.extent(0); ++i) total += on_host(i);
    return total;
  }

  // Functors are public: nvcc launches no others.

  struct Force {
    Drive drive;
    RandomStream stream;

    KOKKOS_FUNCTION Push<Real> drag(DrivenDisk<Real> const& disk) const {
      return drag_force(drive.drag, disk);
    }
    KOKKOS_FUNCTION Push<Real> push(DrivenDisk<Real> disk, std::int64_t i,
                                    std::int64_t step) const {
      if constexpr (Drive::random) {
        auto const random =
            stream.centred(static_cast<std::uint64_t>(i), static_cast<std::uint64_t>(step));
        disk.random = {random.x, random.y};
        disk.random_spin = random.z;
      }
      return drive.push(disk);
    }
    KOKKOS_FUNCTION Push<Real> both(Disks const& disks, std::int64_t i) const {
      auto const disk = disks(i);
      auto total = drag(disk);
      total += push(disk, i, disks.step);
      return total;
    }
  };

  struct Kick {
    SpeciesTable table;
    Real time_step;

    Kick times(Real share) const { return {table, share * time_step}; }

    KOKKOS_FUNCTION Motion<Rotates> operator()(Push<Real> const& push, Species species) const {
      Motion<Rotates> change;
      change.velocity = time_step * table.inverse_mass[species] * push.force;
      if constexpr (Rotates) change.spin = time_step * table.inverse_inertia[species] * push.torque;
      return change;
    }
  };

  KOKKOS_FUNCTION static void add(Motion<Rotates>& to, Motion<Rotates> const& change) {
    to.velocity += change.velocity;
    if constexpr (Rotates) to.spin += change.spin;
  }

  struct KickDisk {
    Disks disks;
    Force force;
    Kick kick;
    Motions to;

    KOKKOS_FUNCTION void operator()(std::int64_t i) const {
      add(to(i), kick(force.both(disks, i), disks.species(i)));
    }
  };

  struct KickChange {
    Disks disks;
    SecondDrag second;
    Kick kick;
    Motions change, motion;

    KOKKOS_FUNCTION void operator()(std::int64_t i) const {
      add(motion(i), kick(second(disks.of(change(i), i)), disks.species(i)));
    }
  };

  struct KickCorrection {
    Disks trial;
    Force force;
    Kick kick;
    Real time;  ///< that the new velocity moves the disk for, [tau_e]
    Motions motion;
    Positions position;

    KOKKOS_FUNCTION void operator()(std::int64_t i) const {
      auto const change = kick(force.both(trial, i), trial.species(i));
      add(motion(i), change);
      position(i) += time * change.velocity;
    }
  };

  struct PowerOfDisk {
    Disks disks;
    Force force;
    SecondDrag second;
    TrialShares shares;
    Motions after, change;
    Kokkos::View<DrivePower*, Space> power;

    KOKKOS_FUNCTION void operator()(std::int64_t i) const {
      auto const disk = disks(i);
      auto const then = disks.moving(after(i), i);
      DrivenDisk<Real> halfway;
      Push<Real> drag;
      if (change.extent(0) != 0) {
        halfway = disk;
        halfway.velocity = 0.5 * (disk.velocity + then.velocity);
        halfway.spin = (disk.spin + then.spin) / 2;
        drag = force.drag(disk);
        drag += second(disks.of(change(i), i));
      } else {
        halfway = shares.halfway(disk, then);
        drag = force.drag(shares.dragged(disk, then));
      }
      auto push = force.push(disk, i, disks.step);
      if constexpr (!Rotates) push.torque = 0;
      power(i) = {-power_of(drag, halfway, disks.strain_rate),
                  power_of(push, halfway, disks.strain_rate)};
    }
  };

 private:
  template <class Body>
  static void for_all(Space const& space, char const* label, Disks const& disks, Body const& body) {
    Launches<Space>{space}.for_all(label, static_cast<std::int64_t>(disks.species.extent(0)), body);
  }

  Force force_;
  SecondDrag second_;
  TrialShares trial_shares_;
  Kick kick_;
  SchemeOnDisk scheme_;
};

}  // namespace bagnold
