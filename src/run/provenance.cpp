// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/provenance.hpp"

#include <fmt/format.h>

#include <Kokkos_Macros.hpp>
#include <fstream>

#include "git_version.hpp"
#include "src/engine/levels/levels.hpp"
#include "src/engine/make_simulation.hpp"

namespace bagnold {

namespace {

std::string cpu_model() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);)
    if (line.starts_with("model name"))
      return line.substr(std::min(line.size(), line.find(':') + 2));
  return "unknown";
}

std::string compiler() {
#if defined(__clang__)
  return fmt::format("clang {}", __clang_version__);
#elif defined(__GNUC__)
  return fmt::format("g++ {}", __VERSION__);
#else
  return "unknown";
#endif
}

std::string levels_in_words() {
  auto const used = chosen_level().name;
  std::vector<std::string_view> others;
  for (auto const& level : levels())
    if (level.here && level.name != used) others.push_back(level.name);
  if (others.empty()) return std::string(used);
  return fmt::format("{} (also: {})", used, fmt::join(others, ", "));
}

}  // namespace

Provenance provenance() {
  return {BAGNOLD_VERSION,
          BAGNOLD_GIT_HASH,
          compiler(),
          fmt::format("{}.{}.{}", KOKKOS_VERSION / 10000, KOKKOS_VERSION / 100 % 100,
                      KOKKOS_VERSION % 100),
          fmt::format("{}", fmt::join(backend_names(), " ")),
          levels_in_words(),
          cpu_model()};
}

}  // namespace bagnold
