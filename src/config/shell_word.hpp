// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace bagnold {

/// A word for a command line of sh, in quotes unless all its characters are plain: file names in
/// commands that messages propose.
std::string shell_word(std::string const& word);

}  // namespace bagnold
