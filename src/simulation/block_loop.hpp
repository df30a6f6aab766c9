// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Core.hpp>
#include <cstddef>
#include <cstdint>
#include <string>

#include "kernels/core/side_by_side.hpp"

namespace bagnold {

/// Runs a body for each of some blocks on the threads of a host space, with scratch of the thread.
template <class Space>
class BlockLoop {
 public:
  /// body(b)
  template <class Body>
  void operator()(std::uint32_t count, Body const& body) const {
    if (count == 1) return body(0);  // no thread is worth waking
    side_by_side::parallel_for("simulation::BlockLoop", Policy(space_, 0, count),
                         [&](std::int64_t b) { body(static_cast<std::uint32_t>(b)); });
  }

  /// body(b, scratch), scratch: [size] of T, as the last body left it.
  template <class T, class Body>
  void with_scratch(std::uint32_t count, std::size_t size, Body const& body) {
    auto const stride = (size * sizeof(T) + 63) / 64 * 64;
    auto const bytes = stride * static_cast<std::size_t>(tokens_.size());
    if (scratch_.extent(0) < bytes) {
      scratch_ = {};
      scratch_ = Kokkos::View<std::byte*, Kokkos::HostSpace>(
          Kokkos::view_alloc(Kokkos::WithoutInitializing, std::string("simulation::scratch")),
          bytes);
    }
    (*this)(count, [&](std::uint32_t b) {
      int const token = tokens_.acquire();
      body(b, reinterpret_cast<T*>(scratch_.data() + stride * static_cast<std::size_t>(token)));
      tokens_.release(token);
    });
  }

 private:
  using Policy = Kokkos::RangePolicy<Space, Kokkos::IndexType<std::int64_t>>;
  Space space_{};
  Kokkos::Experimental::UniqueToken<Space> tokens_;
  Kokkos::View<std::byte*, Kokkos::HostSpace> scratch_;
};

}  // namespace bagnold
