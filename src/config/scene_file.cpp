// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/scene_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "src/config/abilities.hpp"
#include "src/config/contradictions.hpp"
#include "src/config/errors.hpp"
#include "src/config/keys.hpp"
#include "src/config/ladder.hpp"
#include "src/config/meant_key.hpp"
#include "src/config/mistakes.hpp"
#include "src/config/names.hpp"
#include "src/config/nearest_word.hpp"
#include "src/config/shell_word.hpp"
#include "src/config/shown.hpp"
#include "src/config/toml_table.hpp"
#include "src/config/toml_text.hpp"
#include "src/config/value_advice.hpp"

namespace bagnold {

namespace {

/// One scene text being read into a scene.
class Reader {
 public:
  /// `overrides`: keys put over the text, and where they were given.
  Reader(toml::table const& table, std::string origin,
         std::map<std::string, std::string> const& overrides, Mistakes& mistakes)
      : table_(table), origin_(std::move(origin)), overrides_(overrides), mistakes_(mistakes) {}

  Scene read() {
    Scene scene;
    for_each_key(scene, [&](Key const& key, auto&) { known_.push_back(std::string(key.name)); });
    for (auto const& [name, node] : table_) look_at(std::string(name.str()), node);
    std::vector<std::string> missing;
    for_each_key(scene, [&](Key const& key, auto& member) {
      bool const protocol_known = !mistakes_.about("shear.protocol");
      if (toml::node const* node = table_.at_path(key.name).node())
        mistakes_.collect(std::string(key.name), [&] {
          if (protocol_known) refuse_other_protocol(key, *node, scene.shear);
          take(key, *node, member);
        });
      else if (key.required && !mistakes_.about(key.name) &&
               (protocol_known || !key.name.starts_with("shear.")))
        missing.push_back(fmt::format("{} is missing ({})", key.name, key.meaning));
    });
    if (!missing.empty())
      mistakes_.add("", fmt::format("{}: {}; every scene must give {}", origin_,
                                    fmt::join(missing, ", "), missing.size() == 1 ? "it" : "them"));
    auto& shear = scene.shear;
    if (shear.changes_box() && shear.inertial_number && shear.strain_rate == 0)
      shear.strain_rate = *shear.inertial_number * std::sqrt(shear.pressure);
    if (abilities_of(scene).own_scheme && !has("integration.scheme"))
      scene.integration.scheme = automatic;
    return scene;
  }

  bool has(std::string_view key) const { return table_.at_path(key).node() != nullptr; }

 private:
  /// "file:line:column: ", or the command line's.
  std::string place(std::string_view name, toml::node const& node) const {
    if (auto const set = overrides_.find(std::string(name)); set != overrides_.end())
      return set->second + ": ";
    auto const begin = node.source().begin;
    auto const inside = std::string(name) + ".";  // a table that only the command line gives
    if (auto const set = overrides_.lower_bound(inside);
        begin.line == 0 && set != overrides_.end() && set->first.starts_with(inside))
      return set->second + ": ";
    return fmt::format("{}:{}:{}: ", origin_, begin.line, begin.column);
  }

  /// Adds a mistake for each unknown key or table, in `name` and in all tables inside it.
  void look_at(std::string const& name, toml::node const& node) {
    bool const is_table_name = std::any_of(known_.begin(), known_.end(), [&](std::string const& k) {
      return k.starts_with(name + ".");
    });
    if (is_table_name && node.is_table()) {
      for (auto const& [inner, inner_node] : *node.as_table())
        look_at(name + "." + std::string(inner.str()), inner_node);
      return;
    }
    if (is_table_name)
      return mistakes_.add(name, fmt::format("{}{} = {} (must be a table); write [{}]",
                                             place(name, node), name, describe(node), name));
    if (std::find(known_.begin(), known_.end(), name) != known_.end()) return;
    bool const table = node.is_table() && name.find('.') == std::string::npos;
    if (table && node.as_table()->size() == 1 && nearest_word(name, tables()).empty()) {
      // run.seed: the key says more than the table
      std::string const inner(node.as_table()->begin()->first.str());
      auto const last = [](std::string const& key) { return key.substr(key.rfind('.') + 1); };
      if (std::ranges::count(known_, inner, last) == 1)
        return look_at(name + "." + inner, node.as_table()->begin()->second);
    }
    auto const meant = table ? meant_table(name, tables()) : meant_key(name, known_);
    bool const given = meant.key.empty() || table_.at_path(meant.key).node() != nullptr;
    mistakes_.add(given ? "" : meant.key,
                  fmt::format("{}unknown {} {}{}", place(name, node),
                              node.is_table() ? "table" : "key", shown(name), meant.remark));
  }

  /// Names of all tables, in the order of the keys.
  std::vector<std::string> tables() const {
    std::vector<std::string> names;
    for (auto const& key : known_)
      if (auto const dot = key.find('.'); dot != std::string::npos)
        if (auto const table = key.substr(0, dot); std::ranges::count(names, table) == 0)
          names.push_back(table);
    return names;
  }

  [[noreturn]] void refuse(Key const& key, toml::node const& node, std::string const& why) const {
    throw InputError(fmt::format("{}{} = {} ({}): {}", place(key.name, node), key.name,
                                 describe(node), why, key.meaning));
  }

  /// Refuses a value of another type than the key's, with a suggestion.
  [[noreturn]] void refuse_kind(Key const& key, toml::node const& node, std::string why,
                                Wanted wanted = Wanted::number) const {
    if (node.is_array() && key.name == "shear.strain_rate")
      why +=
          "; several rates in one run are shear.strain_rates of shear.protocol = \"cascade\", runs "
          "of "
          "their own a sweep: [sweep] grid = { \"shear.strain_rate\" = [...] }";
    else if (node.is_array())
      why += fmt::format(
          "; a run for each of several is a sweep: [sweep] grid = {{ \"{}\" = [...] }}", key.name);
    if (auto const* text = node.as_string()) {
      auto const advice = value_advice(text->get(), wanted);
      why += advice.empty() ? ", without quotes" : "; " + advice;
    }
    refuse(key, node, why);
  }

  void refuse_other_protocol(Key const& key, toml::node const& node,
                             Scene::Shear const& shear) const {
    if (!belongs(key, shear.protocol))
      throw InputError(fmt::format(
          "{}{} = {} (belongs to shear.protocol = \"{}\", not \"{}\"): {}; leave it out or change "
          "shear.protocol",
          place(key.name, node), key.name, describe(node), fmt::join(key.protocols, "\" or \""),
          shear.protocol, key.meaning));
    if (key.name == "shear.strain" && node.is_array() && !shear.run_per_rate())
      refuse(key, node, "must be a number; a list belongs to shear.protocol = \"cascade\"");
  }

  void in_range(Key const& key, toml::node const& node, double value) const {
    if (!std::isfinite(value)) refuse(key, node, "must be finite");
    if (value < key.least || value > key.most || (key.open_below && value == key.least))
      refuse(key, node,
             fmt::format("must be {} {:g}{}{}", key.open_below ? "above" : "at least", key.least,
                         std::isfinite(key.most) ? fmt::format(" and at most {:g}", key.most) : "",
                         key.unit.empty() ? "" : fmt::format(", in {}", key.unit)));
  }

  void take(Key const& key, toml::node const& node, std::string& member) const {
    auto const* text = node.as_string();
    if (!text && key.words.empty()) refuse(key, node, "must be a text, in quotes");
    if (!text)
      refuse(key, node,
             fmt::format("must be one of \"{}\", in quotes", fmt::join(key.words, "\", \"")));
    member = text->get();
    auto const known = [&](std::string_view word) {
      return std::ranges::count(key.words, word) > 0;
    };
    if (!key.words.empty() && !known(member))
      refuse(key, node, fmt::format("must be one of \"{}\"", fmt::join(key.words, "\", \"")));
  }

  void take(Key const& key, toml::node const& node, bool& member) const {
    auto const* flag = node.as_boolean();
    if (!flag) refuse_kind(key, node, "must be true or false", Wanted::choice);
    member = flag->get();
  }

  void take(Key const& key, toml::node const& node, std::int64_t& member) const {
    auto const* number = node.as_integer();
    if (auto const* real = node.as_floating_point();
        real != nullptr && std::abs(real->get()) < 1e15 && std::floor(real->get()) == real->get())
      refuse(key, node, fmt::format("must be an integer; write {:.0f}", real->get()));
    if (!number) refuse_kind(key, node, "must be an integer", Wanted::whole);
    member = number->get();
    in_range(key, node, static_cast<double>(member));
  }

  void take(Key const& key, toml::node const& node, double& member) const {
    if (auto const* number = node.as_floating_point())
      member = number->get();
    else if (auto const* whole = node.as_integer())
      member = static_cast<double>(whole->get());
    else
      refuse_kind(key, node, "must be a number");
    in_range(key, node, member);
  }

  void take(Key const& key, toml::node const& node, std::optional<double>& member) const {
    auto const* text = node.as_string();
    if (text && text->get() == "auto") return member.reset();
    if (text && !value_advice(text->get()).empty()) refuse_kind(key, node, "must be a number");
    if (text) refuse(key, node, "must be a number or \"auto\"");
    take(key, node, member.emplace());
  }

  void take(Key const& key, toml::node const& node, NumberOrWord& member) const {
    auto const* text = node.as_string();
    if (!text) return take(key, node, (member = 0.0).number.value());
    if (!value_advice(text->get()).empty()) refuse_kind(key, node, "must be a number");
    member = text->get().c_str();
    if (std::find(key.words.begin(), key.words.end(), member.word) == key.words.end())
      refuse(key, node,
             fmt::format("must be a number or one of \"{}\"", fmt::join(key.words, "\", \"")));
  }

  void take(Key const& key, toml::node const& node, std::vector<double>& member) const {
    auto const* list = node.as_array();
    if (!list || list->empty()) refuse(key, node, "must be a list of numbers, [1e-3, 1e-4]");
    member.clear();
    for (auto const& one : *list) take(key, one, member.emplace_back());
  }

  void take(Key const& key, toml::node const& node, std::vector<SequencePiece>& member) const {
    auto const* list = node.as_array();
    constexpr char pairs[] =
        "must be a list of [rate, strain], [[1e-4, 2], [-1e-4, 2]]; a stop is [0, time]";
    if (!list || list->empty()) refuse(key, node, pairs);
    member.clear();
    for (auto const& one : *list) {
      auto const* pair = one.as_array();
      if (!pair || pair->size() != 2) refuse(key, node, pairs);
      auto& piece = member.emplace_back();
      take(key, *pair->get(0), piece.rate);
      Key amount = key;
      amount.least = 0, amount.most = 1e12, amount.open_below = true;
      amount.unit = piece.rate == 0 ? "tau_e" : "";
      take(amount, *pair->get(1), piece.amount);
    }
  }

  void take(Key const& key, toml::node const& node, NumberOrList& member) const {
    if (node.is_array())
      take(key, node, member.each);
    else
      take(key, node, (member = 0.0).each.front());
  }

  void take(Key const& key, toml::node const& node, std::map<std::string, double>& member) const {
    auto const* table = node.as_table();
    if (!table) refuse(key, node, "must be a table, { B_p = 0.02 }");
    member.clear();
    for (auto const& [name, one] : *table) take(key, one, member[std::string(name.str())]);
  }

  toml::table const& table_;
  std::string origin_;
  std::map<std::string, std::string> const& overrides_;
  Mistakes& mistakes_;
  std::vector<std::string> known_;
};

/// Puts one override into a scene. A value that is not TOML, and does not begin like it, is a
/// string: a word or a path.
void put_override(toml::table& scene, Override const& put) {
  if (put.key.find_first_not_of(key_letters) != std::string::npos)
    throw InputError(
        fmt::format("{}: {} is no key; write --set table.key=value", put.origin, shown(put.key)));

  toml::table parsed;
  try {
    parsed = parse_toml("value = " + put.value, put.origin);
  } catch (InputError const&) {
    if (put.value.find_first_of("\"'[{") == 0 || put.value.find('\n') != std::string::npos) throw;
    if (put.value.empty())
      throw InputError(
          fmt::format("{}: gives no value; write --set {}=VALUE", put.origin, put.key));
    refuse_strange_bytes("'" + put.value + "'", put.origin);
    parsed.insert("value", put.value);
  }
  if (parsed.size() != 1)
    throw InputError(fmt::format("{}: one key and one value, please", put.origin));

  auto const dot = put.key.find('.');
  toml::node& node = *parsed.get("value");
  if (dot == std::string::npos) {
    scene.insert_or_assign(put.key, node);
    return;
  }
  std::string const outer = put.key.substr(0, dot), inner = put.key.substr(dot + 1);
  if (!scene.get_as<toml::table>(outer)) scene.insert_or_assign(outer, toml::table{});
  scene.get_as<toml::table>(outer)->insert_or_assign(inner, node);
}

/// "table.key=value" of the command line.
Override from_command_line(std::string const& text) {
  auto const equals = text.find('=');
  std::string const origin = "--set " + shown(text);
  if (equals == std::string::npos || equals == 0)
    throw InputError(fmt::format("{}: write --set table.key=value", origin));
  return {text.substr(0, equals), text.substr(equals + 1), origin};
}

Scene scene_of(toml::table table, std::string const& origin, std::filesystem::path const& folder,
               std::vector<Override> const& overrides) {
  std::map<std::string, std::string> set;
  Mistakes mistakes;
  for (auto const& put : overrides) {
    mistakes.collect(put.key, [&] { put_override(table, put); });
    set[put.key] = put.origin;
  }
  Reader reader(table, origin, set, mistakes);
  Scene scene = reader.read();
  find_contradictions(scene, origin, mistakes);
  mistakes.throw_any();
  if (!reader.has("integration.scheme") && auto_is_default(scene))
    scene.integration.scheme = automatic;
  if (!scene.start.file.empty())
    scene.start.file =
        std::filesystem::absolute(folder / scene.start.file).lexically_normal().string();
  return scene;
}

}  // namespace

Scene parse_scene(std::string_view text, std::string const& origin,
                  std::filesystem::path const& folder, std::vector<std::string> const& overrides) {
  toml::table table = parse_toml(text, origin);
  if (auto const* sweep = table.get("sweep"); sweep && sweep->is_table())
    throw InputError(fmt::format(
        "{}:{}:{}: [sweep] makes many scenes of this one; run them all with "
        "`bagnold sweep {}`",
        origin, sweep->source().begin.line, sweep->source().begin.column, shell_word(origin)));
  std::vector<Override> put;
  for (auto const& one : overrides) put.push_back(from_command_line(one));
  return scene_of(std::move(table), origin, folder, put);
}

Scene parse_point(std::string_view text, std::string const& origin,
                  std::filesystem::path const& folder, std::vector<Override> const& values) {
  toml::table table = parse_toml(text, origin);
  table.erase("sweep");
  return scene_of(std::move(table), origin, folder, values);
}

Scene read_scene(std::filesystem::path const& file, std::vector<std::string> const& overrides) {
  return parse_scene(read_text(file), file.string(), std::filesystem::absolute(file).parent_path(),
                     overrides);
}

Scene read_kept_scene(std::filesystem::path const& file) {
  std::error_code ignored;
  if (std::filesystem::is_fifo(file, ignored))
    throw InputError(
        fmt::format("{}: is a pipe, not the file that a run keeps; remove it", file.string()));
  return read_scene(file);
}

}  // namespace bagnold
