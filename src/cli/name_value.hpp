// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

namespace bagnold {

/// "NAME=VALUE" of an option, split; throws InputError where there is no `=` or no name.
std::map<std::string, std::string> name_values(std::vector<std::string> const& pairs,
                                               std::string const& option);

/// Numbers by name. Throws InputError for a value that is no number.
std::map<std::string, double> name_numbers(std::vector<std::string> const& pairs,
                                           std::string const& option);

}  // namespace bagnold
