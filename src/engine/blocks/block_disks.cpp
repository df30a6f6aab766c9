// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/blocks/block_disks.hpp"

#include <cmath>
#include <utility>

#include "src/engine/device_copy.hpp"
#include "src/engine/failure.hpp"

namespace bagnold {

DiskList take_disks(State& state) {
  DiskList disks;
  disks.position = vectors(std::exchange(state.position, {}));
  disks.velocity = vectors(std::exchange(state.velocity, {}));
  disks.spin = std::exchange(state.spin, {});
  return disks;
}

Real BlockDisks::fastest() const {
  Real fastest2 = 0;
  for (std::uint32_t b = 0; b < system.blocks.count; ++b)
    fastest2 =
        std::max(fastest2, fastest2_of(system.blocks.block(b), system.now, clock.strain_rate));
  return std::sqrt(fastest2);
}

std::size_t BlockDisks::fastest_disk() const {
  auto const speed2 = [&](std::size_t disk) {
    auto const& r = system.now.record(system.blocks.slot_of(disk));
    Real const ux = std::fma(-clock.strain_rate, r.y, r.vx);
    return std::fma(ux, ux, r.vy * r.vy);
  };
  std::size_t disk = 0;
  for (std::size_t i = 1; i < count(); ++i)
    if (speed2(i) > speed2(disk)) disk = i;
  return disk;
}

void BlockDisks::change_motions(RateChange const& change) {
  auto const [factor, rise] = change;
  (*loop)(system.blocks.count, [&, factor = factor, rise = rise](std::uint32_t b) {
    auto const& block = system.blocks.block(b);
    if (factor != 1) scale_motion(block, system.now, factor);
    if (rise != 0) follow_flow(block, system.now, rise);
  });
}

DiskList BlockDisks::disks() const {
  DiskList list;
  gather(list.position, list.velocity, list.spin);
  return list;
}

State BlockDisks::state() const {
  State state;
  gather(state.position, state.velocity, state.spin);
  state.diameter = diameter;
  clock.tell(state, system.step);
  return state;
}

/// All disks in the order of the start. Vector: of two numbers.
template <class Vector>
void BlockDisks::gather(std::vector<Vector>& position, std::vector<Vector>& velocity,
                        std::vector<double>& spin) const {
  position.resize(count());
  velocity.resize(count());
  if (system.rotates) spin.resize(count());
  for (std::size_t i = 0; i < count(); ++i) {
    auto const slot = system.blocks.slot_of(i);
    auto const& r = system.now.record(slot);
    position[i] = {r.x, r.y};
    velocity[i] = {r.vx, r.vy};
    if (system.rotates) spin[i] = system.now.spin(slot);
  }
}

void BlockDisks::fail() const {
  failure::check_finite(clock, system.step, state());
  auto const [overlap, disk] = deepest();
  failure::too_deep(clock, system.step, disk, overlap);
}

/// Largest relative overlap at which the forces were last evaluated, and a disk that has it.
std::pair<Real, std::size_t> BlockDisks::deepest() const {
  std::pair<Real, std::uint32_t> found{-1, 0};
  auto const& blocks = system.blocks;
  bool const at_start = stepper->uses(Uses::changes);  // forces were those where the step began
  auto const place = [&](std::uint32_t slot) -> Vec2<Real> {
    auto const& r = at_start ? system.now.record(slot) : system.trial.record(slot);
    if (at_start) return {r.x - clock.time_step * r.vx, r.y - clock.time_step * r.vy};
    return {r.x, r.y};
  };
  for (std::uint32_t b = 0; b < blocks.count; ++b) {
    Block const& block = blocks.block(b);
    if (at_start) refresh_halo(blocks, block, system.now, box_at(system.step));
    for (int c = 0; c < pair_classes; ++c)
      for (std::uint32_t k = 0; k < block.near[inner_list][c]; ++k) {
        auto const pair = blocks.near[inner_list](block.pairs[c] + k);
        auto const p = place(block.first + pair.a()), q = place(block.first + pair.b());
        Real const overlap = 1 - std::hypot(p.x - q.x, p.y - q.y) / class_distance(c);
        if (overlap > found.first) found = {overlap, block.first + std::min(pair.a(), pair.b())};
      }
  }
  std::size_t disk = 0;
  while (disk + 1 < count() && blocks.slot_of(disk) != found.second) ++disk;
  return {found.first, disk};
}

}  // namespace bagnold
