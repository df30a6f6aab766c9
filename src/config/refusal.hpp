// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace bagnold {

/// Reason to refuse a scene, and the keys that cause it.
struct Refusal {
  std::vector<std::string_view> keys;
  std::string message;
};

}  // namespace bagnold
