// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/csv.hpp"

#include <fmt/format.h>

#include <cmath>

namespace bagnold::analysis {
namespace {

std::string quoted(std::string const& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string out = "\"";
  for (char const letter : text)
    out += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return out + "\"";
}

void put_line(std::string& out, std::vector<std::string> const& cells) {
  for (std::size_t k = 0; k < cells.size(); ++k) {
    if (k != 0) out += ',';
    out += quoted(cells[k]);
  }
  out += '\n';
}

}  // namespace

std::string cell(double value) { return std::isnan(value) ? "" : fmt::format("{}", value); }

std::string to_csv(Rows const& rows) {
  std::string out;
  put_line(out, rows.columns);
  for (auto const& row : rows.rows) put_line(out, row);
  return out;
}

}  // namespace bagnold::analysis
