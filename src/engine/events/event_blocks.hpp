// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "src/engine/blocks/block_loop.hpp"
#include "src/engine/events/event_block.hpp"

namespace bagnold::events {

/// How disks are put together.
struct BlockPlan {
  std::shared_ptr<BlockLoop> each{};     ///< over blocks; none: all disks go by one queue
  std::uint32_t size = 8 * usual_group;  ///< own disks of a block: whole groups
  std::uint32_t group = usual_group;     ///< disks that are added up together
  int depth = 4;                         ///< of halos, in lists of lists: about 7 d_s

  /// Blocks where they pay: that of one thread stay in its cache.
  static BlockPlan of(std::shared_ptr<BlockLoop> each, std::size_t disks);
};

/// Blocks in which disks go alone through windows of time, side by side on all threads.
///
/// Windows that fail are repeated with deeper halos, and where that does not help all disks go on
/// by one queue. So all bits are those of the one queue, whatever blocks and windows are.
template <bool Rotates>
class EventBlocks {
 public:
  EventBlocks(EventState<Rotates>& whole, EventLoop<Rotates>& loop, BlockPlan plan)
      : whole_(whole), loop_(loop), plan_(std::move(plan)) {}

  /// As EventLoop::run, but that the queue of the whole is not kept.
  void run(Real until);

  BlockLoop& threads() { return *plan_.each; }

  /// Lists have been built.
  void forget();
  /// Disks of the whole have changed.
  void look_again() {
    all_changed_ = true;
    queue_known_ = false;
  }

 private:
  using Block = EventBlock<Rotates>;
  using Numbers = std::vector<std::uint32_t>;

  template <class Body>
  void each(std::size_t count, Body const& body) {
    (*plan_.each)(static_cast<std::uint32_t>(count), body);
  }
  void build();
  void build(std::uint32_t b, int depth);
  Real window_end(Real until) const;
  bool go_alone(Real& until);
  void go_together(Real until);
  void run_blocks(Numbers const& blocks, Real until);
  Numbers wrong_blocks(Real window);
  void give();
  void set_window(Real gone, std::int64_t collisions);
  void pause();

  EventState<Rotates>& whole_;
  EventLoop<Rotates>& loop_;
  BlockPlan plan_;
  std::vector<std::unique_ptr<Block>> blocks_;
  bool all_changed_ = true;
  bool queue_known_ = false;            ///< of the whole
  Real window_ = 0;                     ///< [tau_e]
  std::size_t failed_ = 0;              ///< blocks of the window under way, each time
  std::size_t ran_ = 0, repeated_ = 0;  ///< blocks since lists were built, each time
  int together_ = 0;                    ///< builds of lists for which all disks go by one queue
  int pause_ = 1;                       ///< how many it will be when too many blocks fail next
};

extern template class EventBlocks<false>;
extern template class EventBlocks<true>;

}  // namespace bagnold::events
