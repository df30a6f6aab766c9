// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/events/event_part.hpp"

namespace bagnold::events {

Part make_part(EventLists const& lists, std::uint32_t first, std::uint32_t count, int depth) {
  Part part{first, count, depth, 0, {}, {}};
  thread_local std::vector<bool> taken;  // all false outside of here
  taken.resize(lists.count());
  auto& all = part.of_whole;
  for (std::uint32_t i = first; i < first + count; ++i) {
    taken[i] = true;
    all.push_back(i);
  }
  std::vector<std::uint32_t> neighbors;
  std::size_t from = 0;
  for (int k = 0; k < depth; ++k) {
    auto const until = all.size();
    for (; from < until; ++from)
      for (auto e = lists.begin(all[from]); e < lists.end(all[from]); ++e) {
        auto const j = lists.entry(e).index();
        if (taken[j]) continue;
        taken[j] = true;
        all.push_back(j);
      }
    if (k == 0) neighbors.assign(all.begin() + count, all.end());
  }
  for (auto const i : all) taken[i] = false;
  std::vector<std::uint32_t> halo(all.begin() + count, all.end());
  std::ranges::sort(halo);
  auto const above = std::ranges::lower_bound(halo, first);
  part.own_first = static_cast<std::uint32_t>(above - halo.begin());
  all.resize(count);
  all.insert(all.begin(), halo.begin(), above);
  all.insert(all.end(), above, halo.end());
  std::ranges::sort(neighbors);
  for (auto const j : neighbors) part.neighbors.push_back(part.place(j));
  return part;
}

}  // namespace bagnold::events
