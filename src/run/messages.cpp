// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/messages.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace bagnold {

void say(std::string const& message) { std::fputs(("bagnold: " + message + "\n").c_str(), stderr); }

void warn(std::string const& message) {
  if (!message.empty()) say("warning: " + message);
}

void put(std::string const& text) {
  std::fputs(text.c_str(), stdout);
  std::fflush(stdout);
}

std::string finish_output() {
  errno = 0;
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return "";
  return std::string("standard output could not be written") +
         (errno != 0 ? std::string(" (") + std::strerror(errno) + ")" : "");
}

}  // namespace bagnold
