// SPDX-License-Identifier: BSD-3-Clause
#include "src/sweep/sweep_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <sstream>

#include "src/config/errors.hpp"
#include "src/config/keys.hpp"
#include "src/config/shown.hpp"
#include "src/config/toml_table.hpp"

namespace bagnold::sweep {

namespace {

constexpr std::int64_t largest_exact = std::int64_t{1}
                                       << 53;  ///< integers up to here are doubles too

/// Reads the lists of one sweep file.
class TableReader {
 public:
  explicit TableReader(std::string origin) : origin_(std::move(origin)) {}

  SweepTable read(toml::table const& file) {
    auto const* table = file.get_as<toml::table>("sweep");
    if (!table)
      throw InputError(
          fmt::format("{}: has no table [sweep]; a single scene is run with `bagnold "
                      "run {}`",
                      origin_, origin_));
    SweepTable sweep;
    for (auto const& [key, node] : *table) take(std::string(key.str()), node, sweep);
    if (sweep.grid.empty() && sweep.zip.empty())
      refuse(*table, "[sweep] varies nothing; write grid = { \"table.key\" = [value, value] }");
    check_lengths(sweep.zip);
    check_keys(sweep);
    if (auto const* chain = table->get("chain")) check_chain(sweep, *chain);
    return sweep;
  }

 private:
  std::string place(toml::source_region const& at) const {
    return fmt::format("{}:{}:{}", origin_, at.begin.line, at.begin.column);
  }
  [[noreturn]] void refuse(toml::node const& node, std::string const& why) const {
    throw InputError(fmt::format("{}: {}", place(node.source()), why));
  }

  void take(std::string const& name, toml::node const& node, SweepTable& sweep) const {
    if (name == "chain") {
      if (!node.is_string())
        refuse(node, fmt::format("sweep.chain = {} (must be a varied key)", describe(node)));
      sweep.chain = node.as_string()->get();
    } else if (name == "grid" || name == "zip") {
      if (!node.is_table())
        refuse(node, fmt::format("sweep.{} = {} (must be a table of lists); write {} = {{ "
                                 "\"table.key\" = [value, value] }}",
                                 name, describe(node), name));
      lists(name, "", *node.as_table(), name == "grid" ? sweep.grid : sweep.zip);
    } else {
      refuse(node,
             fmt::format("unknown key sweep.{}; [sweep] takes grid, zip and chain", shown(name)));
    }
  }

  /// Reads the lists of a table in the order of the file; `table.key` without quotes is a table in
  /// it.
  void lists(std::string const& where, std::string const& prefix, toml::table const& table,
             std::vector<VariedKey>& keys) const {
    using Entry = std::pair<toml::key const*, toml::node const*>;
    std::vector<Entry> entries;
    for (auto const& [key, node] : table) entries.emplace_back(&key, &node);
    std::ranges::sort(entries, [](Entry const& a, Entry const& b) {
      auto const one = a.first->source().begin, two = b.first->source().begin;
      return std::pair(one.line, one.column) < std::pair(two.line, two.column);
    });
    for (auto const& [key, node] : entries) {
      std::string const name = prefix + std::string(key->str());
      if (name.find_first_not_of(key_letters) != std::string::npos)
        refuse(*node, fmt::format("sweep.{}: {} is no key; write \"table.key\" = [value, value]",
                                  where, shown(name)));
      if (auto const* inner = node->as_table())
        lists(where, name + ".", *inner, keys);
      else
        keys.push_back(list(where, name, place(key->source()), *node));
    }
  }

  VariedKey list(std::string const& where, std::string const& name, std::string const& at,
                 toml::node const& node) const {
    auto const* values = node.as_array();
    if (!values)
      refuse(node, fmt::format("sweep.{}: {} = {} (must be a list); write {} = [{}], or give it in "
                               "its own table",
                               where, name, describe(node), name, describe(node)));
    if (values->empty())
      refuse(node, fmt::format("sweep.{}: {} = [] (must have a value); leave it out or fill it",
                               where, name));
    VariedKey key{name, at, {}};
    for (auto const& value : *values) key.values.push_back(given(name, value));
    return key;
  }

  VariedKey::Given given(std::string const& name, toml::node const& node) const {
    if (node.is_table()) refuse(node, fmt::format("{}: a table is no value to vary", name));
    std::ostringstream out;
    node.visit([&](auto const& value) { out << value; });
    VariedKey::Given one{out.str(), out.str(), place(node.source())};
    if (auto const* text = node.as_string()) one.value = text->get();
    if (auto const* number = node.as_floating_point()) one.value = number->get();
    if (auto const* whole = node.as_integer()) {
      if (whole->get() > largest_exact || whole->get() < -largest_exact)
        refuse(node,
               fmt::format("{} = {} (must be at most 2^53 in a sweep: its tables hold doubles)",
                           name, whole->get()));
      one.value = static_cast<double>(whole->get());
    }
    return one;
  }

  void check_lengths(std::vector<VariedKey> const& zip) const {
    for (auto const& key : zip)
      if (key.values.size() != zip.front().values.size())
        throw InputError(fmt::format(
            "{}: sweep.zip: {} has {} values, {} has {} (must be as many); "
            "make them equal, or use grid for every combination",
            key.place, key.name, key.values.size(), zip.front().name, zip.front().values.size()));
  }

  void check_keys(SweepTable const& sweep) const {
    std::vector<std::string> seen;
    for (auto const* keys : {&sweep.zip, &sweep.grid})
      for (auto const& key : *keys) {
        if (std::ranges::count(seen, key.name) != 0)
          throw InputError(
              fmt::format("{}: {} is varied twice; give it in one list, of grid or of zip",
                          key.place, key.name));
        seen.push_back(key.name);
      }
  }

  void check_chain(SweepTable const& sweep, toml::node const& node) const {
    for (auto const* keys : {&sweep.zip, &sweep.grid})
      for (auto const& key : *keys)
        if (key.name == sweep.chain) return;
    refuse(node, fmt::format("sweep.chain = \"{}\" (must be a key that grid or zip varies)",
                             shown(sweep.chain)));
  }

  std::string origin_;
};

}  // namespace

bool is_sweep(std::string_view text, std::string const& origin) {
  return parse_toml(text, origin).get_as<toml::table>("sweep") != nullptr;
}

SweepTable read_sweep_table(std::string_view text, std::string const& origin) {
  return TableReader(origin).read(parse_toml(text, origin));
}

std::string without_sweep(std::string_view text, std::string const& origin) {
  auto table = parse_toml(text, origin);
  table.erase("sweep");
  std::ostringstream out;
  out << table << '\n';
  return out.str();
}

std::string text_of(Value const& value) {
  if (auto const* number = std::get_if<double>(&value)) return fmt::format("{}", *number);
  return std::get<std::string>(value);
}

}  // namespace bagnold::sweep
