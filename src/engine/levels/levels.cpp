// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/levels/levels.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>

#include "kernels/cpu/simd/level.hpp"
#include "src/config/errors.hpp"
#include "src/config/listed.hpp"
#include "src/engine/blocks/make_block_engine.hpp"
#include "src/engine/law_engines.hpp"
#include "src/engine/levels/level_engine.hpp"

namespace bagnold {

namespace {

std::unique_ptr<Simulation> make_for_all(EngineInput const& input, Snapshot& snapshot,
                                         std::string const& backend) {
  return make_block_engine(input, snapshot, backend, engines_for(input.model).stepper);
}

Level everything_else() { return {simd::level_name, true, make_for_all}; }

/// Level avx512 is x86-64-v4, avx2 is x86-64-v3.
std::vector<Level> levels_of_build() {
  std::vector<Level> all;
#ifdef BAGNOLD_LEVEL_AVX512
  all.push_back({"avx512",
                 __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                     __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw") &&
                     __builtin_cpu_supports("avx512cd"),
                 avx512::make_block_engine});
#endif
  if (simd::level_name == "avx512") all.push_back(everything_else());
#ifdef BAGNOLD_LEVEL_AVX2
  all.push_back({"avx2",
                 __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                     __builtin_cpu_supports("bmi2"),
                 avx2::make_block_engine});
#endif
  if (simd::level_name != "avx512") all.push_back(everything_else());
  return all;
}

}  // namespace

std::vector<Level> const& levels() {
  static std::vector<Level> const all = levels_of_build();
  return all;
}

Level const& chosen_level() {
  auto const& all = levels();
  char const* const asked = std::getenv("BAGNOLD_SIMD");
  if (asked == nullptr || *asked == '\0') return *std::ranges::find(all, true, &Level::here);
  std::vector<std::string_view> usable;
  for (auto const& level : all)
    if (level.here) usable.push_back(level.name);
  if (std::ranges::count(usable, asked) == 0)
    throw InputError(
        fmt::format("BAGNOLD_SIMD = \"{}\" (not in this build, or not for this processor); use {}",
                    asked, fmt::join(usable, ", ")));
  return *std::ranges::find(all, asked, &Level::name);
}

Level const& level_of(std::string_view law, std::string_view drive) {
  static Level const plain = everything_else();
  return is_listed(law, drive) ? chosen_level() : plain;
}

}  // namespace bagnold
