// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/last_words.hpp"

#include <fstream>
#include <string_view>
#include <system_error>

namespace bagnold {

std::string last_words(std::filesystem::path const& log, std::uintmax_t before) {
  constexpr std::string_view mark = "bagnold: ";
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(log, ignored)) return "";  // a pipe would be waited for
  std::ifstream in(log);
  in.seekg(static_cast<std::streamoff>(before));
  std::string words;
  for (std::string line; std::getline(in, line);)
    if (line.starts_with(mark)) words = line.substr(mark.size());
  return words;
}

}  // namespace bagnold
