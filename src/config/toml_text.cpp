// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/toml_text.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "src/config/errors.hpp"

namespace bagnold {

std::string read_text(std::filesystem::path const& file) {
  constexpr std::size_t most = 1 << 20;
  std::error_code error;
  if (std::filesystem::is_directory(file, error))
    throw InputError(fmt::format("{}: is a folder, not a scene file", file.string()));
  std::ifstream in(file, std::ios::binary);
  if (!in)
    throw InputError(fmt::format("{}: cannot be read ({}); check the path", file.string(),
                                 std::strerror(errno)));
  std::string text(most + 1, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  if (in.bad()) throw InputError(fmt::format("{}: reading failed", file.string()));
  if (text.size() > most)
    throw InputError(fmt::format("{}: over 1 MiB; a scene file is a few lines", file.string()));
  return text;
}

void refuse_strange_bytes(std::string_view text, std::string const& origin) {
  enum class In { code, comment, string } in = In::code;
  std::string_view closing;  // of the string we are in
  int line = 1, column = 0;
  for (std::size_t k = 0; k < text.size(); ++k) {
    auto const byte = static_cast<unsigned char>(text[k]);
    ++column;
    bool const control = (byte < 0x20 && byte != '\t' && byte != '\n' && byte != '\r') ||
                         byte == 0x7f;
    if (control || (byte >= 0x80 && in == In::code))
      throw InputError(fmt::format(
          "{}:{}:{}: byte 0x{:02x} does not belong in a scene file; save it as plain text", origin,
          line, column, byte));
    if (byte == '\n') {
      ++line;
      column = 0;
      if (in == In::comment || (in == In::string && closing.size() == 1)) in = In::code;
      continue;
    }
    if (in == In::code && byte == '#') {
      in = In::comment;
    } else if (in == In::code && (byte == '"' || byte == '\'')) {
      bool const triple = text.substr(k, 3) == "\"\"\"" || text.substr(k, 3) == "'''";
      closing = text.substr(k, triple ? 3 : 1);
      in = In::string;
      k += closing.size() - 1;
    } else if (in == In::string && byte == '\\' && closing[0] == '"') {
      ++k;
    } else if (in == In::string && text.substr(k, closing.size()) == closing) {
      k += closing.size() - 1;
      in = In::code;
    }
  }
}

}  // namespace bagnold
