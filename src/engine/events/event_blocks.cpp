// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/events/event_blocks.hpp"

#include <algorithm>
#include <numeric>

namespace bagnold::events {

namespace {

constexpr Real wanted_share = 0.25;     // of collisions, a disk in a window
constexpr Real first_window = 1e-3;     // [strain]
constexpr int most_repeats = 3;         // of a window, each with halos that are deeper by one
constexpr int longest_pause = 64;       // builds of lists
constexpr std::size_t many_failed = 8;  // a failure for as many blocks or fewer

constexpr std::size_t least_size = 4 * usual_group;
constexpr std::size_t least_blocks = 8;  // on one thread

}  // namespace

BlockPlan BlockPlan::of(std::shared_ptr<BlockLoop> each, std::size_t disks) {
  BlockPlan plan;
  if (!each) return plan;
  auto const threads = static_cast<std::size_t>(each->threads());
  auto const of_thread = (disks / threads + usual_group - 1) / usual_group * usual_group;
  plan.size = static_cast<std::uint32_t>(
      std::clamp(of_thread, least_size, static_cast<std::size_t>(plan.size)));
  bool const pays = disks > (threads > 1 ? 1 : least_blocks - 1) * plan.size;
  if (pays) plan.each = std::move(each);
  return plan;
}

template <bool Rotates>
void EventBlocks<Rotates>::forget() {
  blocks_.clear();
  queue_known_ = false;
  together_ = std::max(together_ - 1, 0);
  std::size_t const most = plan_.each->threads() > 1 ? 2 : 12;
  if (most * repeated_ > ran_) pause();
  ran_ = repeated_ = 0;
}

/// Blocks do not pay for some builds of lists: more each time.
template <bool Rotates>
void EventBlocks<Rotates>::pause() {
  together_ = pause_;
  pause_ = std::min(2 * pause_, longest_pause);
}

template <bool Rotates>
void EventBlocks<Rotates>::run(Real until) {
  if (window_ == 0) window_ = first_window / whole_.disks.strain_rate;
  Real& now = whole_.disks.now;
  while (!whole_.too_deep && now < std::min(until, whole_.build_time())) {
    if (together_ > 0) return go_together(until);
    if (blocks_.empty()) build();
    auto const before = whole_.counts.collisions;
    Real end = window_end(until);
    if (go_alone(end)) {
      set_window(end - now, whole_.counts.collisions - before);
      now = end;
    } else {
      blocks_.clear();
      repeated_ = 0;
      pause();
    }
  }
}

template <bool Rotates>
void EventBlocks<Rotates>::go_together(Real until) {
  if (!queue_known_) loop_.predict_all();
  queue_known_ = true;
  loop_.run(until);
}

template <bool Rotates>
void EventBlocks<Rotates>::build() {
  blocks_.resize((whole_.disks.count() + plan_.size - 1) / plan_.size);
  each(blocks_.size(), [&](std::uint32_t b) { build(b, plan_.depth); });
  all_changed_ = true;
}

template <bool Rotates>
void EventBlocks<Rotates>::build(std::uint32_t b, int depth) {
  auto const first = b * plan_.size, count = std::min(plan_.size, whole_.disks.count() - first);
  blocks_[b] = std::make_unique<Block>(whole_, make_part(whole_.lists, first, count, depth));
}

/// At most the end of the step in which the first disk leaves its reach.
template <bool Rotates>
Real EventBlocks<Rotates>::window_end(Real until) const {
  Real leaves = never;
  if (!all_changed_)
    for (auto const& block : blocks_) leaves = std::min(leaves, block->leaves());
  leaves = std::max(leaves, whole_.disks.now);  // 0: of a line that never comes into reach
  Real const end = std::min({until, whole_.build_time(), whole_.disks.now + window_});
  return leaves < end ? std::min(end, whole_.times.time(whole_.times.step_at(leaves))) : end;
}

/// The next window is to have about the wanted share of collisions, and few failures.
template <bool Rotates>
void EventBlocks<Rotates>::set_window(Real gone, std::int64_t collisions) {
  Real const share = static_cast<Real>(collisions) / static_cast<Real>(whole_.disks.count());
  if (many_failed * failed_ > blocks_.size())
    window_ = gone / 2;
  else if (2 * gone > window_)
    window_ *= std::clamp<Real>(wanted_share / std::max<Real>(share, 1e-9), 0.5, 2);
}

/// Goes through a window, or through a shorter one if lists are to be built within: whether all is
/// as one queue has it.
template <bool Rotates>
bool EventBlocks<Rotates>::go_alone(Real& until) {
  Numbers all(blocks_.size());
  std::iota(all.begin(), all.end(), 0u);
  auto some = all;
  failed_ = 0;
  for (int repeats = 0;;) {
    run_blocks(some, until);
    auto build_step = whole_.build_step;
    for (auto const& block : blocks_) build_step = std::min(build_step, block->build_step());
    if (Real const end = whole_.times.time(build_step); end < until) {
      until = end;
      all_changed_ = true;
      some = all;
      continue;
    }
    some = wrong_blocks(until - whole_.disks.now);
    if (some.empty()) break;
    failed_ += some.size();
    repeated_ += some.size();
    if (repeats++ == most_repeats) return false;
    each(some.size(), [&](std::uint32_t k) { build(some[k], blocks_[some[k]]->depth() + 1); });
  }
  give();
  return true;
}

template <bool Rotates>
void EventBlocks<Rotates>::run_blocks(Numbers const& blocks, Real until) {
  ran_ += blocks.size();
  each(blocks.size(), [&](std::uint32_t k) {
    auto& block = *blocks_[blocks[k]];
    block.begin(all_changed_);
    block.run(until);
  });
  all_changed_ = false;
}

template <bool Rotates>
auto EventBlocks<Rotates>::wrong_blocks(Real window) -> Numbers {
  std::vector<std::uint8_t> wrong(blocks_.size());
  auto const of = [&](std::uint32_t disk) -> Block const& { return *blocks_[disk / plan_.size]; };
  each(blocks_.size(), [&](std::uint32_t b) {
    wrong[b] = blocks_[b]->failed() || !blocks_[b]->agrees(of, window);
  });
  Numbers all;
  for (std::uint32_t b = 0; b < wrong.size(); ++b)
    if (wrong[b] != 0) all.push_back(b);
  return all;
}

template <bool Rotates>
void EventBlocks<Rotates>::give() {
  each(blocks_.size(), [&](std::uint32_t b) { blocks_[b]->give_paths(whole_); });
  queue_known_ = false;
  whole_.disks.clusters.clear();
  for (auto const& block : blocks_) block->give_rest(whole_);
}

template class EventBlocks<false>;
template class EventBlocks<true>;

}  // namespace bagnold::events
