// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/csv.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "src/config/errors.hpp"

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

std::optional<double> number_in(std::string const& text) {
  char* end = nullptr;
  double const value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !std::isfinite(value)) return std::nullopt;
  return value;
}

Rows parse_csv(std::string const& text, std::string const& origin) {
  Rows out;
  std::vector<std::string> row(1);
  std::size_t line = 1;
  auto const finish_row = [&] {
    bool const is_blank = row.size() == 1 && row.front().empty();
    if (out.columns.empty())
      out.columns = row;
    else if (is_blank && out.columns.size() > 1)
      ;  // no row
    else if (row.size() != out.columns.size())
      throw InputError(fmt::format("{}:{}: {} cells (must be {}, as many as names in line 1)",
                                   origin, line, row.size(), out.columns.size()));
    else
      out.rows.push_back(row);
    row.assign(1, "");
    ++line;
  };
  bool in_quotes = false;
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";  // of spreadsheets
  for (std::size_t k = text.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
       k < text.size(); ++k) {
    char const letter = text[k];
    if (in_quotes && letter == '"' && k + 1 < text.size() && text[k + 1] == '"')
      row.back() += text[++k];
    else if (letter == '"')
      in_quotes = !in_quotes;
    else if (in_quotes || (letter != ',' && letter != '\n' && letter != '\r'))
      row.back() += letter;
    else if (letter == ',')
      row.emplace_back();
    else if (letter == '\n')
      finish_row();
  }
  if (in_quotes) throw InputError(fmt::format("{}: a quote is left open; close it", origin));
  if (row.size() > 1 || !row.front().empty()) finish_row();
  return out;
}

std::string to_csv(Rows const& rows) {
  std::string out;
  put_line(out, rows.columns);
  for (auto const& row : rows.rows) put_line(out, row);
  return out;
}

}  // namespace bagnold::analysis
