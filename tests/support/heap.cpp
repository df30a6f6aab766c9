// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/heap.hpp"

#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::int64_t> live{0};

void* counted(void* at) {
  if (!at) throw std::bad_alloc();
  live += static_cast<std::int64_t>(malloc_usable_size(at));
  return at;
}

void forget(void* at) {
  live -= static_cast<std::int64_t>(malloc_usable_size(at));
  std::free(at);
}

}  // namespace

void* operator new(std::size_t size) { return counted(std::malloc(size)); }
void* operator new(std::size_t size, std::align_val_t align) {
  auto const unit = static_cast<std::size_t>(align);
  return counted(std::aligned_alloc(unit, (size + unit - 1) / unit * unit));
}
void operator delete(void* at) noexcept { forget(at); }
void operator delete(void* at, std::size_t) noexcept { forget(at); }
void operator delete(void* at, std::align_val_t) noexcept { forget(at); }
void operator delete(void* at, std::size_t, std::align_val_t) noexcept { forget(at); }

std::int64_t bagnold::test::heap_bytes() { return live; }
