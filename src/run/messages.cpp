// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/messages.hpp"

#include <cstdio>

namespace bagnold {

void say(std::string const& message) { std::fputs(("bagnold: " + message + "\n").c_str(), stderr); }

void warn(std::string const& message) {
  if (!message.empty()) say("warning: " + message);
}

}  // namespace bagnold
