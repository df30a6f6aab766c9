// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include "bench/spent.hpp"

namespace bagnold::bench {

/// The rate of the core's clock, from additions each of which waits for the one before: a cycle
/// each.
void clock_rate(benchmark::State& run) {
  constexpr std::int64_t unrolled = 32;
  std::uint64_t x = 0;
  Spent const begin = spent_so_far();
  for (auto _ : run)
    for (int n = 0; n < 1'000'000; ++n)
#pragma GCC unroll 32
      for (std::int64_t k = 0; k < unrolled; ++k) {
        ++x;
        asm volatile("" : "+r"(x));
      }
  Spent const spent = spent_so_far() - begin;
  run.counters["cycles_per_second"] =
      static_cast<double>(run.iterations() * unrolled) * 1e6 / spent.cpu;
}

BENCHMARK(clock_rate)->Iterations(20);

}  // namespace bagnold::bench
