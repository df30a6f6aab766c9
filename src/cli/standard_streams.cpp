// SPDX-License-Identifier: BSD-3-Clause
#include "src/cli/standard_streams.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <initializer_list>

namespace bagnold {

void open_standard_streams() {
  for (int const stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(stream, F_GETFD) < 0)
      open("/dev/null", O_RDWR);  // takes the lowest number that is free
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
