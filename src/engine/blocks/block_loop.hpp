// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "kernels/cpu/blocks/blocks.hpp"

namespace bagnold {

/// Runs a body for each of some blocks on the threads of a host backend, with scratch memory for
/// each thread. The backend is behind this interface, so engines are compiled once for all
/// backends.
class BlockLoop {
 public:
  virtual ~BlockLoop() = default;

  /// Calls body(b) for each block b.
  template <class Body>
  void operator()(std::uint32_t count, Body const& body) {
    run(count, 0, &body, [](void const* body, std::uint32_t b, std::byte*) {
      (*static_cast<Body const*>(body))(b);
    });
  }

  /// Calls body(b, scratch) for each block b. scratch: [size] of T, as the last body left it.
  template <class T, class Body>
  void with_scratch(std::uint32_t count, std::size_t size, Body const& body) {
    run(count, size * sizeof(T), &body, [](void const* body, std::uint32_t b, std::byte* scratch) {
      (*static_cast<Body const*>(body))(b, reinterpret_cast<T*>(scratch));
    });
  }

  /// Zero bytes, first touched by these threads. Views would ask Kokkos to fill them, which is not
  /// possible in threads of replicas.
  template <class T>
  Blocks::Array<T> zeros(char const* label, std::size_t size) {
    auto const array = Blocks::room<T>(label, size);
    std::size_t const bytes = size * sizeof(T), piece = std::size_t{1} << 20;
    auto* const begin = reinterpret_cast<std::byte*>(array.data());
    (*this)(static_cast<std::uint32_t>((bytes + piece - 1) / piece), [=](std::uint32_t k) {
      std::memset(begin + k * piece, 0, std::min(piece, bytes - k * piece));
    });
    return array;
  }

  /// Number of threads.
  virtual int threads() const = 0;

  /// Builds blocks as kernels/cpu/blocks/build_blocks.hpp says. position: [N], in the box, [d_s].
  virtual Blocks build(std::vector<Vec2<Real>> const& position, std::vector<Species> const& species,
                       SpeciesTable const& table, ShearedBox const& box, Real skin,
                       std::uint32_t size) = 0;

 protected:
  using Call = void (*)(void const* body, std::uint32_t b, std::byte* scratch);

 private:
  virtual void run(std::uint32_t count, std::size_t scratch_bytes, void const* body, Call call) = 0;
};

/// Loop of a backend; nullptr if the build does not have it, or it is not a host backend.
std::unique_ptr<BlockLoop> make_block_loop(std::string const& backend);

}  // namespace bagnold
