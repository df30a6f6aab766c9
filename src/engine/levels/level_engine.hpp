// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "src/engine/engine_input.hpp"
#include "src/engine/simulation.hpp"

/// Function that a level exports. All its other functions are local, so that none compiled for one
/// kind of processor is called on another (src/engine/levels/level.cmake).
#define BAGNOLD_LEVEL_ENGINE(level)                                            \
  namespace bagnold::level {                                                   \
  std::unique_ptr<Simulation> make_block_engine(EngineInput const&, Snapshot&, \
                                                std::string const& backend);   \
  }
BAGNOLD_LEVEL_ENGINE(avx512)
BAGNOLD_LEVEL_ENGINE(avx2)
#undef BAGNOLD_LEVEL_ENGINE
