// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cpu/islands/predict_contacts.hpp"

namespace bagnold {

/// Islands: sets of disks that may meet each other during a lookahead and no other disks. Islands
/// are independent of each other.
///
/// Each island is unfolded: its disks are taken at the images `image` at which they lie side by
/// side, so that its pairs have no image.
struct Islands {
  struct Disk {
    std::uint32_t slot;
    Image image;  ///< at which it is taken
  };
  struct Pair {
    std::uint32_t a, b;  ///< places in `disks`
  };

  std::vector<Disk> disks;                ///< island by island
  std::vector<Pair> pairs;                ///< island by island
  std::vector<std::uint32_t> first_disk;  ///< [islands + 1]
  std::vector<std::uint32_t> first_pair;  ///< [islands + 1]
  bool unfolds = true;                    ///< false: an island closes on itself round the box

  std::size_t count() const { return first_disk.size() - 1; }
};

/// Finds islands by breadth-first search. Scratch memory is kept from call to call.
class IslandFinder {
 public:
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  /// slots: number in all blocks.
  void resize(std::uint32_t slots) {
    node_of_.assign(slots, none);
    slots_.clear();
  }

  void find(std::vector<SlotPair> const& meeting, Islands& islands) {
    forget();
    for (auto const& pair : meeting) {
      ++degree_[node(pair.a)];
      ++degree_[node(pair.b.index())];
    }
    list_neighbours(meeting);
    search(meeting, islands);
  }

 private:
  struct Edge {
    std::uint32_t node, pair;
    bool forward;  ///< along the pair, from a to b
  };

  void forget() {
    for (auto const slot : slots_) node_of_[slot] = none;
    slots_.clear();
    degree_.clear();
  }

  std::uint32_t node(std::uint32_t slot) {
    if (node_of_[slot] == none) {
      node_of_[slot] = static_cast<std::uint32_t>(slots_.size());
      slots_.push_back(slot);
      degree_.push_back(0);
    }
    return node_of_[slot];
  }

  void list_neighbours(std::vector<SlotPair> const& meeting) {
    first_edge_.assign(slots_.size() + 1, 0);
    for (std::size_t n = 0; n < slots_.size(); ++n)
      first_edge_[n + 1] = first_edge_[n] + degree_[n];
    edges_.resize(first_edge_.back());
    auto& next = degree_;
    for (std::size_t n = 0; n < slots_.size(); ++n) next[n] = first_edge_[n];
    for (std::uint32_t p = 0; p < meeting.size(); ++p) {
      auto const a = node_of_[meeting[p].a], b = node_of_[meeting[p].b.index()];
      edges_[next[a]++] = {b, p, true};
      edges_[next[b]++] = {a, p, false};
    }
  }

  void search(std::vector<SlotPair> const& meeting, Islands& islands) {
    islands.disks.clear();
    islands.pairs.clear();
    islands.first_disk.assign(1, 0);
    islands.first_pair.assign(1, 0);
    islands.unfolds = true;
    place_.assign(slots_.size(), none);
    order_.clear();
    for (std::uint32_t root = 0; root < slots_.size(); ++root) {
      if (place_[root] != none) continue;
      auto visited = static_cast<std::uint32_t>(order_.size());
      reach(root, {}, islands);
      for (; visited < order_.size(); ++visited) walk_on(visited, meeting, islands);
      islands.first_disk.push_back(static_cast<std::uint32_t>(islands.disks.size()));
      islands.first_pair.push_back(static_cast<std::uint32_t>(islands.pairs.size()));
    }
  }

  void reach(std::uint32_t node, Image image, Islands& islands) {
    place_[node] = static_cast<std::uint32_t>(order_.size());
    order_.push_back(node);
    islands.disks.push_back({slots_[node], image});
  }

  void walk_on(std::uint32_t place, std::vector<SlotPair> const& meeting, Islands& islands) {
    auto const from = order_[place];
    Image const image = islands.disks[place].image;
    for (auto e = first_edge_[from]; e < first_edge_[from + 1]; ++e) {
      Edge const edge = edges_[e];
      Image const step = meeting[edge.pair].b.image();
      int const sign = edge.forward ? 1 : -1;
      Image const there{image.m + sign * step.m, image.n + sign * step.n};
      if (place_[edge.node] == none) reach(edge.node, there, islands);
      auto const other = place_[edge.node];
      Image const found = islands.disks[other].image;
      if (found.m != there.m || found.n != there.n) islands.unfolds = false;
      if (edge.forward) islands.pairs.push_back({place, other});
    }
  }

  std::vector<std::uint32_t> node_of_, slots_, degree_, first_edge_, place_, order_;
  std::vector<Edge> edges_;
};

}  // namespace bagnold
