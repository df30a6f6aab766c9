// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/physics/schemes/schemes.hpp"

namespace bagnold {

/// Names of the schemes that tests compare with numbers of their own.
inline constexpr std::string_view papers_scheme = ModifiedVelocityVerlet::name;
inline constexpr std::string_view two_stage_scheme = TwoStageLeapfrog::name;

}  // namespace bagnold
