// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Core.hpp>

#include "kernels/cpu/blocks/large_pages.hpp"
#include "kernels/cpu/simd/records.hpp"
#include "kernels/physics/box/sheared_box.hpp"
#include "kernels/physics/species.hpp"

namespace bagnold {

/// Near lists, each a part of the list before it, the first of the outer list: pairs whose gap can
/// close before the next pruning, and pairs that touch now.
enum NearList : int { inner_list, contact_list, near_lists };

enum HalfOfStep : int { first_half_of_step, second_half_of_step, halves_of_step };

/// A compact patch of disks and all that they may touch, as a stretch of slots:
///
///     own disks | inert ones, to a multiple of eight, at least two | halo
///
/// The halo holds copies of disks of other blocks, and of images, already shifted: so pairs have no
/// image and no foreign partner, and their indices are local. A pair across the edge of a block is
/// in both blocks' lists; each keeps the force on its own disk. The inert disks touch nothing:
/// pairs of them fill up lists.
struct Block {
  std::uint32_t first = 0;   ///< slot of the first own disk
  std::uint32_t own = 0;     ///< disks owned
  std::uint32_t padded = 0;  ///< own and inert
  std::uint32_t halo = 0;
  std::uint32_t halo_first = 0;  ///< in Blocks::halo
  std::uint32_t
      pairs[pair_classes + 1]{};  ///< where the classes begin, in Blocks::outer and ::near
  std::uint32_t near[near_lists][pair_classes]{};  ///< pairs of each class in the near lists

  std::uint32_t local() const { return padded + halo; }
};

/// The disks cut into blocks, and the pairs of each: an outer list within d_ij + skin, and near
/// ones.
struct Blocks {
  template <class T>
  using Array = Kokkos::View<T*, Kokkos::HostSpace>;

  std::uint32_t count = 0;                  ///< blocks
  std::uint32_t slots = 0;                  ///< of all blocks
  std::uint32_t most_local = 0;             ///< largest Block::local()
  Array<Block> block;                       ///< [count]
  Array<Neighbor> halo;                     ///< the slot that each halo disk copies, and its image
  Array<simd::LocalPair> outer;             ///< class segments, multiples of eight
  Array<simd::LocalPair> near[near_lists];  ///< the same places, filled from the front; or empty
  Array<std::uint32_t> slot_of;             ///< [N]: where a disk is, by its index at the start
  Array<std::uint32_t>
      next[halves_of_step];  ///< [count] the block that goes through that half after each; or empty

  /// True if a step reads more than stays in cache from one half to the next.
  bool beyond_cache() const { return slots > 100'000; }

  /// The block that owns a slot.
  std::uint32_t block_of(std::uint32_t slot) const {
    std::uint32_t low = 0, high = count;
    while (high - low > 1) {
      auto const middle = (low + high) / 2;
      (block(middle).first <= slot ? low : high) = middle;
    }
    return low;
  }

  /// Allocates memory without touching it.
  template <class T>
  static Array<T> room(std::string const& label, std::size_t size) {
    Array<T> array(Kokkos::view_alloc(Kokkos::WithoutInitializing, label), size);
    ask_for_large_pages(array.data(), size * sizeof(T));
    return array;
  }

  /// Allocates a near list of the size of the outer one.
  void make_room(NearList list, char const* label) {
    if (near[list].extent(0) >= outer.extent(0)) return;
    near[list] = {};
    near[list] = room<simd::LocalPair>(label, outer.extent(0));
  }
};

}  // namespace bagnold
