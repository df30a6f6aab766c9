// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/toml_text.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include "src/config/errors.hpp"
#include "src/config/shipped_inputs.hpp"
#include "src/config/toml_table.hpp"

namespace bagnold {
namespace {

/// The file itself, or, of `inputs/NAME` that is not there, what came with the program.
std::filesystem::path here_or_installed(std::filesystem::path const& file) {
  std::error_code ignored;
  auto const name = file.lexically_normal();
  if (name.is_absolute() || *name.begin() != "inputs" || std::filesystem::exists(file, ignored))
    return file;
  return find_shipped_input(name.lexically_relative("inputs")).value_or(file);
}

}  // namespace

std::string read_text(std::filesystem::path const& file) {
  constexpr std::size_t most = 1 << 20;
  std::error_code error;
  if (std::filesystem::is_directory(file, error))
    throw InputError(fmt::format("{}: is a folder, not a scene file", file.string()));
  std::ifstream in(here_or_installed(file), std::ios::binary);
  if (!in)
    throw InputError(fmt::format("{}: cannot be read ({}); check the path", file.string(),
                                 std::strerror(errno)));
  std::string text(most + 1, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  if (in.bad())
    throw FileError(fmt::format("{}: reading failed ({}); check the disk", file.string(),
                                std::strerror(errno)));
  if (text.size() > most)
    throw InputError(fmt::format("{}: over 1 MiB; a scene file is a few lines", file.string()));
  return text;
}

std::string toml_as_json(std::string_view text, std::string const& origin) {
  std::ostringstream json;
  json << toml::json_formatter(parse_toml(text, origin));
  return json.str();
}

namespace {

/// Bytes of the UTF-8 character at the start of `text`; 0 if it is none (overlong, surrogate, cut).
std::size_t character_length(std::string_view text) {
  auto const byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  unsigned const lead = byte(0);
  if (lead < 0x80) return 1;
  std::size_t const length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc2 || lead > 0xf4 || text.size() < length) return 0;
  for (std::size_t k = 1; k < length; ++k)
    if ((byte(k) & 0xc0) != 0x80) return 0;
  unsigned const second = byte(1);
  if ((lead == 0xe0 && second < 0xa0) || (lead == 0xed && second > 0x9f) ||
      (lead == 0xf0 && second < 0x90) || (lead == 0xf4 && second > 0x8f))
    return 0;
  return length;
}

}  // namespace

void refuse_strange_bytes(std::string_view text, std::string const& origin) {
  constexpr int most_dots = 100;  // in a key: the parser descends a level for each
  enum class In { code, comment, string } in = In::code;
  std::string_view closing;  // of the string we are in
  int line = 1, dots = 0;
  std::size_t line_start = 0;
  for (std::size_t k = 0; k < text.size(); ++k) {
    auto const byte = static_cast<unsigned char>(text[k]);
    auto const refuse = [&](std::string const& why) {
      throw InputError(fmt::format("{}:{}:{}: {}", origin, line, k - line_start + 1, why));
    };
    bool const control =
        (byte < 0x20 && byte != '\t' && byte != '\n' && byte != '\r') || byte == 0x7f;
    std::size_t const length = character_length(text.substr(k));
    if (control || length == 0 || (byte >= 0x80 && in == In::code))
      refuse(fmt::format("byte 0x{:02x} does not belong in a scene file; save it as plain text",
                         byte));
    if (length > 1) {
      k += length - 1;
    } else if (byte == '\n') {
      ++line;
      line_start = k + 1;
      dots = 0;
      if (in == In::comment || (in == In::string && closing.size() == 1)) in = In::code;
    } else if (in == In::code && byte == '.') {
      if (++dots > most_dots) refuse("too deeply nested; keys are table.key");
    } else if (in == In::code &&
               std::string_view(",=[]{}").find(text[k]) != std::string_view::npos) {
      dots = 0;
    } else if (in == In::code && byte == '#') {
      in = In::comment;
    } else if (in == In::code && (byte == '"' || byte == '\'')) {
      bool const triple = text.substr(k, 3) == "\"\"\"" || text.substr(k, 3) == "\'\'\'";
      closing = text.substr(k, triple ? 3 : 1);
      in = In::string;
      k += closing.size() - 1;
    } else if (in == In::string && byte == '\\' && closing[0] == '"') {
      if (k + 1 < text.size() && text[k + 1] != '\n') ++k;
    } else if (in == In::string && text.substr(k, closing.size()) == closing) {
      k += closing.size() - 1;
      in = In::code;
    }
  }
}

}  // namespace bagnold
