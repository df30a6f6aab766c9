// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "kernels/cpu/steps/block_stepper.hpp"
#include "src/engine/blocks/block_loop.hpp"
#include "src/engine/drive_columns.hpp"
#include "src/engine/run_clock.hpp"
#include "src/state/state.hpp"

namespace bagnold {

/// Disks in the order of the start, as input and output of blocks.
struct DiskList {
  std::vector<Vec2<Real>> position, velocity;  ///< [N], [d_s] and [d_s/tau_e]
  std::vector<double> spin;                    ///< [N], [1/tau_e]; empty if the law does not rotate
};

/// Data that all parts of the block engine share: the disks and how they are stepped.
struct BlockDisks {
  std::unique_ptr<BlockLoop> loop;
  std::unique_ptr<BlockStepper> stepper;
  RunClock clock;
  ShearMark list;                ///< of the outer list's build, since which images move
  std::vector<double> diameter;  ///< [N], [d_s], in the order of the start
  BlockSystem system;

  std::size_t count() const { return diameter.size(); }
  ShearedBox box_at(std::int64_t at) const { return clock.box(at, list); }

  /// Columns of SumColumns that the law has: without spins those of spins are absent.
  std::span<Real const> columns_of(BlockSums const& sums) const {
    return {sums.value, static_cast<std::size_t>(engine_columns(system.rotates, false))};
  }

  /// Largest |v - gammadot y x^|, [d_s/tau_e], and a disk that has it.
  Real fastest() const;
  std::size_t fastest_disk() const;

  /// Changes all motions where the strain rate changes.
  void change_motions(RateChange const& change);

  DiskList disks() const;

  /// Present state of the disks, which may be outside the box.
  State state() const;

  /// Throws the NumericalError for a motion that is NaN or an overlap beyond its limit.
  [[noreturn]] void fail() const;

 private:
  std::pair<Real, std::size_t> deepest() const;

  template <class Vector>
  void gather(std::vector<Vector>& position, std::vector<Vector>& velocity,
              std::vector<double>& spin) const;
};

/// Moves a state's arrays into a list.
DiskList take_disks(State& state);

}  // namespace bagnold
