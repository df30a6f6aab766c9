// SPDX-License-Identifier: BSD-3-Clause
#include "src/sweep/slurm_limit.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>
#include <memory>
#include <optional>
#include <regex>

namespace bagnold::sweep {

namespace {

constexpr std::int64_t default_tasks = 1000;  ///< MaxArraySize is 1001 by default

std::optional<std::int64_t> number_in(std::string const& text, char const* pattern) {
  std::smatch found;
  if (!std::regex_search(text, found, std::regex(pattern))) return std::nullopt;
  return std::stoll(found[1]);
}

}  // namespace

std::int64_t most_array_tasks(std::string const& config) {
  auto const size = number_in(config, "(?:^|\n)MaxArraySize *= *([0-9]{1,15})");
  auto const tasks = number_in(config, "[ =,]max_array_tasks=([0-9]{1,15})");
  auto const most = std::min(size ? *size - 1 : default_tasks,
                             tasks.value_or(std::numeric_limits<std::int64_t>::max()));
  return std::max<std::int64_t>(most, 1);
}

std::int64_t most_array_tasks() {
  // Without a controller scontrol keeps asking for a while.
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> const answer(
      ::popen("timeout 10 scontrol show config 2>/dev/null </dev/null", "re"), ::pclose);
  std::string config;
  std::array<char, 4096> part{};
  while (answer && std::fgets(part.data(), part.size(), answer.get()) != nullptr)
    config += part.data();
  return most_array_tasks(config);
}

}  // namespace bagnold::sweep
