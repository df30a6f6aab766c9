// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace bagnold::test {

/// Live bytes of operator new, which heap.cpp replaces; as the allocator rounds them up.
std::int64_t heap_bytes();

}  // namespace bagnold::test
