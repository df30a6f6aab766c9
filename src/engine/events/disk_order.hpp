// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "kernels/physics/box/sheared_box.hpp"

namespace bagnold::events {

/// Disks along a Hilbert curve through cells of about a disk: [N], the present index of the disk
/// that comes k-th. Of disks in one cell the lower index comes first.
///
/// position: in the box, whose offset is in [0, L_x).
std::vector<std::uint32_t> order_along_curve(std::vector<Vec2<Real>> const& position,
                                             ShearedBox const& box);

/// The values in another order.
template <class Value>
std::vector<Value> in_order(std::vector<Value> const& values,
                            std::vector<std::uint32_t> const& order) {
  std::vector<Value> ordered;
  ordered.reserve(values.size());
  for (auto const i : order) ordered.push_back(values[i]);
  return ordered;
}

}  // namespace bagnold::events
