// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>

#include "kernels/cpu/islands/islands.hpp"
#include "kernels/cpu/steps/block_system.hpp"

namespace bagnold {

/// Islands joined into blocks without halo, on which the block step runs through a whole lookahead
/// in cache. The batch of an island depends on the islands alone.
struct Batches {
  static constexpr std::uint32_t size = 128;  ///< disks from which on a batch is full

  BlockSystem system;
  Blocks::Array<simd::Record> origin;  ///< at the start of the lookahead
  /// By slot, largest squared distance from the straight flight so far, [d_s^2].
  Blocks::Array<Real> flight_deviation2;
  std::vector<std::uint32_t> slot_of;  ///< by place in Islands::disks

  /// Takes islands and the motion of their disks from `all`. Returns false if an island is too
  /// large for a batch.
  bool fill(Islands const& islands, BlockSystem const& all, bool lists_contacts,
            ShearedBox const& box) {
    system.table = all.table;
    system.rotates = all.rotates;
    if (!cut(islands, lists_contacts)) return false;
    slot_of.resize(islands.disks.size());
    for (std::uint32_t b = 0; b < system.blocks.count; ++b) fill_block(b, islands, all, box);
    return true;
  }

  /// First island of a batch, and the one after its last.
  std::pair<std::uint32_t, std::uint32_t> stretch(std::uint32_t b) const { return stretches_[b]; }

 private:
  std::vector<std::pair<std::uint32_t, std::uint32_t>> stretches_;

  template <class T>
  static void need(Blocks::Array<T>& array, std::size_t size, char const* label) {
    if (array.extent(0) >= size) return;
    array = {};
    array = Blocks::Array<T>(Kokkos::view_alloc(Kokkos::WithoutInitializing, std::string(label)),
                             size + size / 4);
  }

  bool cut(Islands const& islands, bool lists_contacts) {
    stretches_.clear();
    auto const count = static_cast<std::uint32_t>(islands.count());
    std::size_t slots = 0, pairs = 0;
    auto& blocks = system.blocks;
    blocks.most_local = 0;
    for (std::uint32_t i = 0; i < count;) {
      auto const begin = i;
      auto const first = islands.first_disk[i];
      while (i < count && islands.first_disk[i] - first < size) ++i;
      stretches_.push_back({begin, i});
      auto const local = simd::round_up(islands.first_disk[i] - first + 2);
      if (local > simd::LocalPair::max_count) return false;
      slots += local;
      pairs += islands.first_pair[i] - islands.first_pair[begin] + pair_classes * simd::list_width;
      blocks.most_local = std::max(blocks.most_local, local);
    }
    blocks.count = static_cast<std::uint32_t>(stretches_.size());
    need(blocks.block, blocks.count, "islands::block");
    need(blocks.near[inner_list], pairs, "islands::pairs");
    if (lists_contacts) need(blocks.near[contact_list], pairs, "islands::contacts");
    need(system.species, slots, "islands::species");
    need(system.now.record, slots, "islands::record");
    need(system.trial.record, slots, "islands::trial_record");
    if (system.rotates) {
      need(system.now.spin, slots, "islands::spin");
      need(system.trial.spin, slots, "islands::trial_spin");
    }
    need(origin, slots, "islands::origin");
    need(flight_deviation2, slots, "islands::deviation");
    return true;
  }

  void fill_block(std::uint32_t b, Islands const& islands, BlockSystem const& all,
                  ShearedBox const& box) {
    auto const [begin, end] = stretches_[b];
    Block block;
    auto const first_place = islands.first_disk[begin];
    if (b > 0) {
      Block const& before = system.blocks.block(b - 1);
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
      if (system.rotates) system.now.spin(slot) = all.now.spin(disk.slot);
    }
    for (auto k = block.own; k < block.padded; ++k) {
      Real const far = 1e3 * box.length * (k - block.own + 1);
      place(block.first + k, {far, 0, 0, 0}, 0);
      if (system.rotates) system.now.spin(block.first + k) = 0;
    }
    list_pairs(block, begin, end, first_place, islands);
    system.blocks.block(b) = block;
  }

  void place(std::uint32_t slot, simd::Record const& record, Species species) {
    system.now.record(slot) = origin(slot) = record;
    system.species(slot) = species;
    flight_deviation2(slot) = 0;
  }

  void list_pairs(Block& block, std::uint32_t begin, std::uint32_t end, std::uint32_t first_place,
                  Islands const& islands) {
    auto const each = [&](auto const& use) {
      for (auto p = islands.first_pair[begin]; p < islands.first_pair[end]; ++p) {
        auto a = islands.pairs[p].a - first_place, b = islands.pairs[p].b - first_place;
        if (system.species(block.first + a) > system.species(block.first + b)) std::swap(a, b);
        use(pair_class(system.species(block.first + a), system.species(block.first + b)), a, b);
      }
    };
    each([&](int c, auto, auto) { ++block.near[inner_list][c]; });
    std::uint32_t to[pair_classes];
    for (int c = 0; c < pair_classes; ++c) {
      to[c] = block.pairs[c];
      block.pairs[c + 1] = block.pairs[c] + simd::round_up(block.near[inner_list][c]);
    }
    each([&](int c, auto a, auto b) {
      system.blocks.near[inner_list](to[c]++) = simd::LocalPair::make(a, b);
    });
    for (int c = 0; c < pair_classes; ++c)
      while (to[c] < block.pairs[c + 1])
        system.blocks.near[inner_list](to[c]++) = simd::LocalPair::make(block.own, block.own + 1);
  }
};

}  // namespace bagnold
