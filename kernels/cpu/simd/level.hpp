// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#ifdef __CUDA_ARCH__
#error "kernels/cpu is for the host alone: hide its users from nvcc (cmake/host_only.cmake)"
#endif

#include <cstdint>
#include <string_view>

/// Instruction set of packs: the one that the compiler may use.
#define BAGNOLD_AVX512 0
#define BAGNOLD_AVX2 0
#define BAGNOLD_128 0
#if defined(__AVX512F__) && defined(__AVX512DQ__)
#undef BAGNOLD_AVX512
#define BAGNOLD_AVX512 1
#elif defined(__AVX2__) && defined(__FMA__)
#undef BAGNOLD_AVX2
#define BAGNOLD_AVX2 1
#else
#undef BAGNOLD_128
#define BAGNOLD_128 1
#endif
#if defined(__x86_64__)
#include <immintrin.h>
#elif defined(__ARM_NEON)
#include <arm_neon.h>
#endif

/// Inlined always: a call in a pack loop costs more than the pack, as registers are saved and
/// restored.
#define BAGNOLD_INLINE [[gnu::always_inline]] inline

namespace bagnold::simd {

/// Doubles in a pack, as many as in a register.
#if defined(__AVX512F__) && defined(__AVX512DQ__)
inline constexpr int width = 8;
#elif defined(__AVX2__) && defined(__FMA__)
inline constexpr int width = 4;
#else
inline constexpr int width = 2;
#endif

/// Width of lists of pairs, eight on every processor, so that forces are summed in one order.
inline constexpr int list_width = 8;

/// Name of the level in BAGNOLD_SIMD.
inline constexpr std::string_view level_name = BAGNOLD_AVX512 ? "avx512"
                                               : BAGNOLD_AVX2 ? "avx2"
                                                              : "baseline";

/// Next multiple of eight.
constexpr std::uint32_t round_up(std::uint32_t n) {
  return (n + list_width - 1) / list_width * list_width;
}

}  // namespace bagnold::simd
