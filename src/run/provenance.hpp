// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace bagnold {

/// Program, build and machine that made a result.
struct Provenance {
  std::string version;   ///< of Bagnold
  std::string git;       ///< hash, with "-dirty" where files were changed
  std::string compiler;  ///< with its version
  std::string kokkos;    ///< version
  std::string backends;  ///< in this build
  std::string simd;      ///< levels in this build that this processor has, the one in use first
  std::string cpu;       ///< model name
};

Provenance provenance();

}  // namespace bagnold
