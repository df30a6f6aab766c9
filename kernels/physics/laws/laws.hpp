// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tuple>

#include "kernels/physics/laws/cd.hpp"
#include "kernels/physics/laws/cd_n.hpp"
#include "kernels/physics/laws/cd_nt.hpp"
#include "kernels/physics/laws/cd_rot.hpp"

namespace bagnold {

/// All contact laws. The program, its messages and its typed tests read this list, or the part that
/// a developer's build selects (BAGNOLD_LAWS).
using AllLaws = std::tuple<CD,     //
                           CDn,    //
                           CDrot,  //
                           CDnt>;

#ifdef BAGNOLD_CHOSEN_LAWS
using Laws = std::tuple<BAGNOLD_CHOSEN_LAWS>;
#else
using Laws = AllLaws;
#endif

}  // namespace bagnold
