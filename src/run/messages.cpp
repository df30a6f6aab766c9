// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/messages.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "src/config/listed.hpp"
#include "src/config/scene.hpp"
#include "src/config/shell_word.hpp"

namespace bagnold {

void say(std::string const& message) { std::fputs(("bagnold: " + message + "\n").c_str(), stderr); }

void warn(std::string const& message) {
  if (!message.empty()) say("warning: " + message);
}

std::string no_more_threads(int threads) {
  return fmt::format(
      "{} threads cannot be started: the system makes no more of them; use fewer --threads, or "
      "raise "
      "the limits of processes (ulimit -u) and memory (ulimit -v, OMP_STACKSIZE)",
      threads);
}

std::string stopped_before_the_first_step(Scene const& scene, std::filesystem::path const& folder) {
  return fmt::format("stopped before the first step; {} begins anew", resuming(scene, folder));
}

std::string resuming(Scene const& scene, std::filesystem::path const& folder) {
  if (!is_listed(scene.disks.model, scene.drive.kind)) return "the same program";
  return fmt::format("`bagnold resume {}`", shell_word(folder.string()));
}

}  // namespace bagnold
