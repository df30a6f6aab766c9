// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include <map>

#include "bench/states.hpp"
#include "src/simulation/make_simulation.hpp"

namespace bagnold::bench {

/// A whole step of the reference engine on one thread: two force evaluations, list builds included.
void step(benchmark::State& run, std::string const& law) {
  Scene const scene = scene_of(law, run.range(0));
  auto const simulation = make_simulation(scene, start_of(scene), "serial");
  std::int64_t const steps = std::max<std::int64_t>(1, 65536 / scene.disks.count);
  OpenWindows unused;
  for (auto _ : run) simulation->advance(steps, Sampling{}, unused);
  run.SetItemsProcessed(run.iterations() * steps * scene.disks.count);  // disk-steps
}

BENCHMARK_CAPTURE(step, CD, "CD")->Arg(1024)->Arg(16384)->Arg(262144);
BENCHMARK_CAPTURE(step, CD_n, "CD_n")->Arg(1024)->Arg(16384)->Arg(262144);
BENCHMARK_CAPTURE(step, CD_rot, "CD_rot")->Arg(1024)->Arg(16384)->Arg(262144);

}  // namespace bagnold::bench
