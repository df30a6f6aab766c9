// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/blocks/block_lists.hpp"

#include <algorithm>
#include <cmath>

#include "kernels/cpu/blocks/prune.hpp"
#include "kernels/cpu/islands/free_flight.hpp"
#include "kernels/physics/box/list_criterion.hpp"
#include "src/engine/device_copy.hpp"

namespace bagnold {

namespace {

/// Disks per block. Larger blocks have a smaller share of halo; with 32 blocks or more no thread is
/// idle for long.
std::uint32_t block_size(std::size_t disks) {
  return static_cast<std::uint32_t>(std::clamp<std::size_t>(disks / 32, 1024, 3072));
}

}  // namespace

void BlockLists::build(DiskList list) {
  disks_.list = disks_.clock.mark(disks_.system.step);
  auto const box = disks_.box_at(disks_.system.step);
  for (std::size_t i = 0; i < disks_.count(); ++i) wrap(box, list.position[i], list.velocity[i].x);
  arrange(std::move(list));
  ++builds;
  outer_nonaffine_bound = 0;
  fastest = disks_.fastest();
}

void BlockLists::arrange(DiskList list, std::vector<Vec2<Real>> const* listed) {
  auto& system = disks_.system;
  auto& loop = *disks_.loop;
  auto const& at_build = listed != nullptr ? *listed : list.position;
  system.blocks = {};  // all is in the arguments: room for the search
  system.now = system.trial = {};
  system.species = {};
  at_build_ = {};
  auto const species = species_of(disks_.diameter);
  system.blocks = loop.build(at_build, species, system.table, disks_.clock.box(disks_.list), skin_,
                             block_size(disks_.count()));
  auto const& blocks = system.blocks;
  system.species = loop.zeros<Species>("state::species", blocks.slots);
  system.now.record = loop.zeros<simd::Record>("state::record", blocks.slots);
  if (system.rotates) system.now.spin = loop.zeros<double>("state::spin", blocks.slots);
  at_build_ = loop.zeros<Vec2<Real>>("neighbors::at_build", blocks.slots);
  for (std::size_t i = 0; i < disks_.count(); ++i) {
    auto const slot = blocks.slot_of(i);
    system.species(slot) = species[i];
    system.now.record(slot) = {list.position[i].x, list.position[i].y, list.velocity[i].x,
                               list.velocity[i].y};
    at_build_(slot) = at_build[i];
    if (system.rotates) system.now.spin(slot) = list.spin[i];
  }
  list = {};

  make_trial();
  wavefront_ = Wavefront(blocks, at_build_, blocks_at_once());
  if (blocks.beyond_cache()) {
    system.blocks.next[first_half_of_step] = next_in(wavefront_.first_half);
    system.blocks.next[second_half_of_step] = next_in(wavefront_.second_half);
  }
  ++system.arrangement;
}

/// Successor of each block in a cyclic order, [blocks].
Blocks::Array<std::uint32_t> BlockLists::next_in(std::vector<std::uint32_t> const& order) {
  auto next = disks_.loop->zeros<std::uint32_t>("blocks::next", order.size());
  for (std::size_t k = 0; k < order.size(); ++k) next(order[k]) = order[(k + 1) % order.size()];
  return next;
}

std::vector<std::array<double, 2>> BlockLists::at_build() const {
  std::vector<std::array<double, 2>> list(disks_.count());
  for (std::size_t i = 0; i < list.size(); ++i) {
    auto const& r = at_build_(disks_.system.blocks.slot_of(i));
    list[i] = {r.x, r.y};
  }
  return list;
}

bool BlockLists::holds_next(ShearMark const& since, Real nonaffine_bound, Real skin) const {
  Real const strain = std::abs(disks_.clock.strain_since(since, disks_.system.step + 1));
  if (strain > 0.5) return false;
  // nonaffine_bound sums |v - gammadot y x^|, whereas w is relative to the flow at the place of the
  // build, which differs by gammadot w_y.
  Real const w =
      (nonaffine_bound + disks_.clock.time_step * fastest * step_strain_factor()) / (1 - strain);
  return list_holds(strain, w * w, skin);
}

void BlockLists::prune(ListUse use) {
  auto const& blocks = disks_.system.blocks;
  for (std::uint32_t b = 0; b < blocks.count; ++b) {
    Block const& block = blocks.block(b);
    use.wider += block.pairs[pair_classes] - block.pairs[0];
  }
  use.kept = near_pairs;
  use.per_step = 2 * disks_.clock.time_step * fastest;
  inner.margin = best_margin(use, inner.margin, skin_);
  inner.mark = disks_.clock.mark(disks_.system.step);
  inner.nonaffine_bound = 0;
  if (!inner_holds()) inner.margin = skin_;
  fill_inner();
  near_pairs = 0;
  for (std::uint32_t b = 0; b < blocks.count; ++b)
    for (auto const n : blocks.block(b).near[inner_list]) near_pairs += n;
}

void BlockLists::fill_inner() {
  auto& blocks = disks_.system.blocks;
  auto const& now = disks_.system.now;
  auto const box = disks_.box_at(disks_.system.step);
  (*disks_.loop)(blocks.count, [&](std::uint32_t b) {
    Block& block = blocks.block(b);
    refresh_halo(blocks, block, now, box);
    prune_block(blocks, block, inner_list, now.record.data() + block.first, inner.margin);
  });
  ++disks_.system.listing;
}

Real BlockLists::farthest() const {
  Real const strain = disks_.clock.strain_since(disks_.list, disks_.system.step);
  Real largest2 = 0;
  for (std::size_t i = 0; i < disks_.count(); ++i) {
    auto const slot = disks_.system.blocks.slot_of(i);
    auto const& r = disks_.system.now.record(slot);
    largest2 = std::max(largest2, nonaffine2({r.x, r.y}, at_build_(slot), strain));
  }
  return std::sqrt(largest2);
}

Real BlockLists::farthest_at(std::int64_t step, Clock const& later, Real duration) {
  auto const& system = disks_.system;
  Real const strain = later.strain_since(disks_.list, step);
  far2_.assign(system.blocks.count, 0);
  (*disks_.loop)(system.blocks.count, [&](std::uint32_t b) {
    Block const& block = system.blocks.block(b);
    far2_[b] = farthest2_after(block, system.now.record.data() + block.first,
                               at_build_.data() + block.first, duration, strain);
  });
  return std::sqrt(*std::max_element(far2_.begin(), far2_.end()));
}

Real BlockLists::room_at(std::int64_t step, Clock const& later, Real farthest) const {
  return list_reach(later.strain_since(disks_.list, step), skin_) - farthest;
}

void BlockLists::give_back_scratch() {
  disks_.system.trial = {};
  for (auto& more : disks_.system.more_records) more = {};
  disks_.system.of_pairs = {};
  for (auto& near : disks_.system.blocks.near) near = {};
}

void BlockLists::take_scratch() {
  disks_.system.blocks.make_room(inner_list, "blocks::inner");
  make_trial();
  fill_inner();
}

/// Allocates the trial state, and sets the inert slots of both states: at rest, far from all disks
/// and from each other.
void BlockLists::make_trial() {
  auto& system = disks_.system;
  auto& blocks = system.blocks;
  auto const uses = [&](unsigned what) { return disks_.stepper->uses(what); };
  if (uses(Uses::contact_pairs)) blocks.make_room(contact_list, "dynamics::contacts");
  system.trial.record = disks_.loop->zeros<simd::Record>("dynamics::trial_record", blocks.slots);
  if (uses(Uses::trial_spins))
    system.trial.spin = disks_.loop->zeros<double>("dynamics::trial_spin", blocks.slots);
  if (uses(Uses::iterates))
    for (auto& more : system.more_records)
      more = disks_.loop->zeros<simd::Record>("dynamics::more_records", blocks.slots);
  if (uses(Uses::separations))
    system.of_pairs = Blocks::room<double>("dynamics::of_pairs", 2 * blocks.outer.extent(0));
  for (std::uint32_t b = 0; b < blocks.count; ++b) make_inert(blocks.block(b));
}

void BlockLists::make_inert(Block const& block) {
  auto& system = disks_.system;
  for (auto i = block.own; i < block.padded; ++i) {
    auto const slot = block.first + i;
    Real const far = 1e3 * disks_.clock.box_length * (i - block.own + 1);
    system.now.record(slot) = system.trial.record(slot) = {far, 0, 0, 0};
    system.species(slot) = 0;
    if (system.rotates) system.now.spin(slot) = 0;
    if (system.trial.spin.extent(0) != 0) system.trial.spin(slot) = 0;
    at_build_(slot) = {far, 0};
  }
}

/// Blocks in a stage: a row of blocks, or enough to keep the threads busy; all of them if they fit
/// into cache.
std::uint32_t BlockLists::blocks_at_once() const {
  auto const& blocks = disks_.system.blocks;
  if (!blocks.beyond_cache()) return blocks.count;
  return std::max(static_cast<std::uint32_t>(std::sqrt(blocks.count)),
                  4 * static_cast<std::uint32_t>(disks_.loop->threads()));
}

}  // namespace bagnold
