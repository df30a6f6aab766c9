// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <string_view>

/// Which instructions packs are made of: those the compiler may use.
#define BAGNOLD_AVX512 0
#define BAGNOLD_AVX2 0
#define BAGNOLD_128 0
#ifndef __CUDA_ARCH__  // nvcc reads host code once more for the device, which knows no vectors
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
#endif

/// A call in a pack loop costs more than the pack: registers go to memory and back.
#define BAGNOLD_INLINE [[gnu::always_inline]] inline

namespace bagnold::simd {

inline constexpr int width = 8;  ///< doubles in a pack

/// By which BAGNOLD_SIMD calls them.
inline constexpr std::string_view level_name = BAGNOLD_AVX512 ? "avx512"
                                               : BAGNOLD_AVX2 ? "avx2"
                                                              : "baseline";

/// The next multiple of the width.
constexpr std::uint32_t round_up(std::uint32_t n) { return (n + width - 1) / width * width; }

}  // namespace bagnold::simd
