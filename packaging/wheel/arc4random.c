/* SPDX-License-Identifier: BSD-3-Clause
 *
 * For std::random_device of the libstdc++ inside the program of a wheel. That of glibc is there from 2.36 on, and would
 * be all that keeps the program from systems with 2.35. */
#include <stdint.h>
#include <stdlib.h>
#include <sys/random.h>

uint32_t arc4random(void) {
  uint32_t word;
  if (getrandom(&word, sizeof word, 0) != (ssize_t)sizeof word) abort();
  return word;
}
