// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kernels/physics/schemes/schemes.hpp"
#include "kernels/physics/type_list.hpp"
#include "src/config/names.hpp"

namespace bagnold {

/// Names of the schemes that tests compare with numbers of their own.
inline constexpr std::string_view papers_scheme = ModifiedVelocityVerlet::name;
inline constexpr std::string_view two_stage_scheme = TwoStageLeapfrog::name;

/// Names of the schemes that do not solve for all motions together: those with steps for few
/// contacts, lookaheads and drives.
inline std::vector<std::string_view> explicit_schemes() {
  auto names = names_of<Schemes>();
  std::erase_if(names, [](auto name) { return is_implicit(name); });
  return names;
}

}  // namespace bagnold
