// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace bagnold::events {

/// Asks memory for all values, in their order, before they are used in another one.
template <class Value>
void prefetch_all(std::vector<Value> const& values) {
  constexpr std::size_t line = 64;
  auto const* const begin = reinterpret_cast<char const*>(values.data());
  for (std::size_t k = 0; k < values.size() * sizeof(Value); k += line)
    __builtin_prefetch(begin + k, 0, 2);
}

}  // namespace bagnold::events
