// SPDX-License-Identifier: BSD-3-Clause
//
// The step on blocks by every scheme, compiled for processors without AVX: packages are
// (cmake/levels.cmake), builds for one machine are not.
#include "kernels/physics/laws/laws.hpp"
#include "src/engine/blocks/make_stepper.hpp"

template std::unique_ptr<bagnold::BlockStepper> bagnold::make_stepper<bagnold::CDrot>(
    bagnold::EngineInput const&);
