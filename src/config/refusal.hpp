// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace bagnold {

/// Why a scene is refused, and by which keys.
struct Refusal {
  std::vector<std::string_view> keys;
  std::string message;
};

}  // namespace bagnold
