// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <thread>

#include "src/cli/options.hpp"
#include "src/run/provenance.hpp"

namespace bagnold {

namespace {

int info_command() {
  Provenance const made = provenance();
  fmt::print(
      "bagnold   {}\ngit       {}\ncompiler  {}\nKokkos    {}\nbackends  {}\nSIMD      {}\nCPU     "
      "  {}, {} "
      "threads\n",
      made.version, made.git, made.compiler, made.kokkos, made.backends, made.simd, made.cpu,
      std::thread::hardware_concurrency());
  return 0;
}

}  // namespace

Command add_info(Words program) {
  return {add_command(program, "info", "version, git hash, Kokkos, backends, SIMD, CPU"),
          info_command};
}

}  // namespace bagnold
