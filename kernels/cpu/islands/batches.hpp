// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cpu/steps/block_system.hpp"
#include "kernels/cpu/islands/islands.hpp"

namespace bagnold {

/// Islands put together to blocks without halo, on which the block step runs through a whole window
/// in cache. Which island is in which batch depends on the islands alone.
template <class Step>
struct Batches {
  static constexpr std::uint32_t size = 128;  ///< disks from which on a batch is full

  Step step;                             ///< blocks, state and species of the batches
  Blocks::Array<simd::Record> origin;    ///< at the start of the window
  Blocks::Array<Real> deviation2;        ///< largest squared distance from the straight flight since
  std::vector<std::uint32_t> slot_of;    ///< by place in Islands::disks

  /// Takes islands and their disks' motion from `all`; false if one is too large for a batch.
  bool fill(Islands const& islands, Step const& all, ShearedBox const& box) {
    step.take_laws(all);
    if (!cut(islands)) return false;
    slot_of.resize(islands.disks.size());
    for (std::uint32_t b = 0; b < step.blocks.count; ++b) fill_block(b, islands, all, box);
    return true;
  }

  struct Stretch {
    std::uint32_t first_island, end_island;
  };
  /// The islands of a batch.
  Stretch stretch(std::uint32_t b) const { return stretches_[b]; }

 private:
  std::vector<Stretch> stretches_;

  template <class T>
  static void need(Blocks::Array<T>& array, std::size_t size, char const* label) {
    if (array.extent(0) >= size) return;
    array = {};
    array = Blocks::Array<T>(Kokkos::view_alloc(Kokkos::WithoutInitializing, std::string(label)),
                             size + size / 4);
  }

  bool cut(Islands const& islands) {
    stretches_.clear();
    auto const count = static_cast<std::uint32_t>(islands.count());
    std::size_t slots = 0, pairs = 0;
    auto& blocks = step.blocks;
    blocks.most_local = 0;
    for (std::uint32_t i = 0; i < count;) {
      auto const begin = i;
      auto const first = islands.first_disk[i];
      while (i < count && islands.first_disk[i] - first < size) ++i;
      stretches_.push_back({begin, i});
      auto const local = simd::round_up(islands.first_disk[i] - first + 2);
      if (local > simd::LocalPair::max_count) return false;
      slots += local;
      pairs += islands.first_pair[i] - islands.first_pair[begin] + pair_classes * simd::width;
      blocks.most_local = std::max(blocks.most_local, local);
    }
    blocks.count = static_cast<std::uint32_t>(stretches_.size());
    need(blocks.block, blocks.count, "islands::block");
    need(blocks.near[inner_list], pairs, "islands::pairs");
    if constexpr (Step::lists_contacts) need(blocks.near[contact_list], pairs, "islands::contacts");
    need(step.species, slots, "islands::species");
    need(step.now.record, slots, "islands::record");
    need(step.trial.record, slots, "islands::trial_record");
    if constexpr (Step::rotates) {
      need(step.now.spin, slots, "islands::spin");
      need(step.trial.spin, slots, "islands::trial_spin");
    }
    need(origin, slots, "islands::origin");
    need(deviation2, slots, "islands::deviation");
    return true;
  }

  void fill_block(std::uint32_t b, Islands const& islands, Step const& all, ShearedBox const& box) {
    auto const [begin, end] = stretches_[b];
    Block block;
    auto const first_place = islands.first_disk[begin];
    if (b > 0) {
      Block const& before = step.blocks.block(b - 1);
      block.first = before.first + before.padded;
      block.pairs[0] = before.pairs[pair_classes];
    }
    block.own = islands.first_disk[end] - first_place;
    block.padded = simd::round_up(block.own + 2);
    for (std::uint32_t k = 0; k < block.own; ++k) {
      auto const& disk = islands.disks[first_place + k];
      auto const slot = block.first + k;
      slot_of[first_place + k] = slot;
      place(slot, at_image(all.now.record(disk.slot), disk.image, box), all.species(disk.slot));
      if constexpr (Step::rotates) step.now.spin(slot) = all.now.spin(disk.slot);
    }
    for (auto k = block.own; k < block.padded; ++k) {
      Real const far = 1e3 * box.length * (k - block.own + 1);
      place(block.first + k, {far, 0, 0, 0}, 0);
      if constexpr (Step::rotates) step.now.spin(block.first + k) = 0;
    }
    list_pairs(block, begin, end, first_place, islands);
    step.blocks.block(b) = block;
  }

  void place(std::uint32_t slot, simd::Record const& record, Species species) {
    step.now.record(slot) = origin(slot) = record;
    step.species(slot) = species;
    deviation2(slot) = 0;
  }

  void list_pairs(Block& block, std::uint32_t begin, std::uint32_t end, std::uint32_t first_place,
                  Islands const& islands) {
    auto const each = [&](auto const& use) {
      for (auto p = islands.first_pair[begin]; p < islands.first_pair[end]; ++p) {
        auto a = islands.pairs[p].a - first_place, b = islands.pairs[p].b - first_place;
        if (step.species(block.first + a) > step.species(block.first + b)) std::swap(a, b);
        use(pair_class(step.species(block.first + a), step.species(block.first + b)), a, b);
      }
    };
    each([&](int c, auto, auto) { ++block.near[inner_list][c]; });
    std::uint32_t to[pair_classes];
    for (int c = 0; c < pair_classes; ++c) {
      to[c] = block.pairs[c];
      block.pairs[c + 1] = block.pairs[c] + simd::round_up(block.near[inner_list][c]);
    }
    each([&](int c, auto a, auto b) { step.blocks.near[inner_list](to[c]++) = simd::LocalPair::make(a, b); });
    for (int c = 0; c < pair_classes; ++c)
      while (to[c] < block.pairs[c + 1])
        step.blocks.near[inner_list](to[c]++) = simd::LocalPair::make(block.own, block.own + 1);
  }
};

/// Keeps how far disks have strayed from the straight flight they were predicted by: at the new
/// position, and at the next trial position.
struct DeviationWatch {
  simd::Record const* origin;
  Real* deviation2;
  Real time;       ///< since the start of the window, at the end of the step
  Real time_step;

  /// A block after `steps` steps.
  void all_of(Block const& block, simd::Record const* records, std::int64_t steps) {
    time = static_cast<Real>(steps) * time_step;
    for (std::uint32_t i = 0; i < block.padded; i += simd::width)
      (*this)(block.first + i, simd::load_records(records + block.first + i));
  }

  void operator()(std::uint32_t slot, simd::Records const& r) const {
    using simd::Pack;
    auto const o = simd::load_records(origin + slot);
    Pack const x = r.x - fma(time, o.vx, o.x), y = r.y - fma(time, o.vy, o.y);
    Pack const next_x = fma(time_step, r.vx - o.vx, x), next_y = fma(time_step, r.vy - o.vy, y);
    Pack const now2 = fma(x, x, y * y), next2 = fma(next_x, next_x, next_y * next_y);
    max(Pack::load(deviation2 + slot), max(now2, next2)).store(deviation2 + slot);
  }
};

}  // namespace bagnold
