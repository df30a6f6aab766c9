// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#ifndef TOML_ASSERT
#define TOML_ASSERT(expression) static_cast<void>(0)
#endif
#include <toml++/toml.h>

namespace bagnold {

/// TOML text as a table; `origin` names it in messages. Throws InputError with line and column.
toml::table parse_toml(std::string_view text, std::string const& origin);

/// Text of a value for messages.
std::string describe(toml::node const& node);

}  // namespace bagnold
