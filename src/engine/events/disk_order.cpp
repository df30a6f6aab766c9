// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/events/disk_order.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "kernels/cpu/blocks/spatial_order.hpp"

namespace bagnold::events {

std::vector<std::uint32_t> order_along_curve(std::vector<Vec2<Real>> const& position,
                                             ShearedBox const& box) {
  auto const cells = static_cast<std::uint32_t>(std::max(box.length, box.height)) + 1;  // in a row
  int const level = std::bit_width(cells);
  std::vector<std::pair<std::uint64_t, std::uint32_t>> places;
  places.reserve(position.size());
  for (std::uint32_t i = 0; i < position.size(); ++i)
    places.emplace_back(hilbert_index(level, static_cast<std::uint32_t>(position[i].x),
                                      static_cast<std::uint32_t>(position[i].y)),
                        i);
  std::ranges::sort(places);
  std::vector<std::uint32_t> order;
  order.reserve(places.size());
  for (auto const& place : places) order.push_back(place.second);
  return order;
}

}  // namespace bagnold::events
