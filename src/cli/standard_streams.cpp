// SPDX-License-Identifier: BSD-3-Clause
#include "src/cli/standard_streams.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <initializer_list>

namespace bagnold {

void open_standard_streams() {
  for (int const stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(stream, F_GETFD) < 0)
      open("/dev/null", O_RDWR);  // takes the lowest number that is free
}

}  // namespace bagnold
