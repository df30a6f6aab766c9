// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Random123/philox.h>

#include <Random123/uniform.hpp>
#include <array>
#include <cstdint>

namespace bagnold {

/// Purpose of a random number of a start, so that no two uses share one.
enum class Purpose : std::uint32_t { position = 1, nudge = 2 };

/// Two numbers in (0, 1), the same for a (seed, disk, purpose) everywhere.
inline std::array<double, 2> random_pair(std::int64_t seed, std::uint64_t disk, Purpose purpose) {
  using Philox = r123::Philox2x64;
  Philox const philox;
  Philox::key_type const key{{static_cast<std::uint64_t>(seed)}};
  Philox::ctr_type const counter{{disk, static_cast<std::uint32_t>(purpose)}};
  Philox::ctr_type const random = philox(counter, key);
  return {r123::u01<double>(random[0]), r123::u01<double>(random[1])};
}

}  // namespace bagnold
