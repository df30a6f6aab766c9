// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include <CLI/CLI.hpp>

#include "bench/rows.hpp"
#include "kernels/device/initialize_kokkos.hpp"

int main(int argc, char** argv) {
  bagnold::bench::RowOptions options;
  CLI::App app(
      "What Bagnold costs; --benchmark_... are Google Benchmark's (--benchmark_list_tests)");
  app.add_option("--states", options.states,
                 "folder with a folder of state.h5 and scene.toml a row")
      ->envname("BAGNOLD_BENCH_STATES")
      ->capture_default_str();
  app.add_option("--shorter", options.shorter, "divide the strains of rows by this")
      ->check(CLI::PositiveNumber);
  app.add_option("--threads", options.threads, "of Kokkos, what one system with threads:T needs")
      ->check(CLI::PositiveNumber);
  app.allow_extras();
  CLI11_PARSE(app, argc, argv);

  std::vector<std::string> rest = app.remaining();
  std::vector<char*> arguments{argv[0]};
  for (auto& argument : rest) arguments.push_back(argument.data());
  int count = static_cast<int>(arguments.size());
  arguments.push_back(nullptr);
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 2;

  bagnold::bench::register_rows(options);
  bagnold::initialize_kokkos(options.threads);
  benchmark::RunSpecifiedBenchmarks();
  Kokkos::finalize();
}
