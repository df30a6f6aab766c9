// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/messages.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace bagnold {

void say(std::string const& message) { std::fputs(("bagnold: " + message + "\n").c_str(), stderr); }

void warn(std::string const& message) {
  if (!message.empty()) say("warning: " + message);
}

std::string stopped_before_the_first_step(std::filesystem::path const& folder) {
  return fmt::format("stopped before the first step; `bagnold resume {}` begins anew",
                     folder.string());
}

}  // namespace bagnold
