// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <thread>

#include "src/cli/options.hpp"
#include "src/run/cores.hpp"
#include "src/run/provenance.hpp"

namespace bagnold {

namespace {

int info_command() {
  Provenance const made = provenance();
  auto const machine = static_cast<int>(std::thread::hardware_concurrency());
  fmt::print(
      "bagnold   {}\ngit       {}\ncompiler  {}\nKokkos    {}\nbackends  {}\nSIMD      {}\nCPU     "
      "  {}, {} threads{}\n",
      made.version, made.git, made.compiler, made.kokkos, made.backends, made.simd, made.cpu,
      cores(),
      machine > cores() ? fmt::format(" (of {}; the rest is not this process's)", machine) : "");
  return 0;
}

}  // namespace

Command add_info(Words program) {
  return {add_command(program, "info", "version, git hash, Kokkos, backends, SIMD, CPU"),
          info_command};
}

}  // namespace bagnold
