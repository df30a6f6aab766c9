// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/scene_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "src/config/errors.hpp"
#include "src/config/keys.hpp"
#include "src/config/nearest_word.hpp"
#include "src/config/toml_table.hpp"
#include "src/config/toml_text.hpp"

namespace bagnold {

namespace {

/// One scene text being read into a scene.
class Reader {
 public:
  /// `overrides`: which keys were put over the text, and where they were given.
  Reader(toml::table const& table, std::string origin,
         std::map<std::string, std::string> const& overrides)
      : table_(table), origin_(std::move(origin)), overrides_(overrides) {}

  Scene read() {
    Scene scene;
    for_each_key(scene, [&](Key const& key, auto&) { known_.push_back(std::string(key.name)); });
    for (auto const& [name, node] : table_) refuse_unknown(std::string(name.str()), node);
    for_each_key(scene, [&](Key const& key, auto& member) {
      if (toml::node const* node = table_.at_path(key.name).node()) {
        refuse_other_protocol(key, *node, scene.shear.protocol);
        take(key, *node, member);
      }
      else if (key.required)
        throw InputError(fmt::format("{}: {} is missing ({}); every scene must give it", origin_,
                                     key.name, key.meaning));
    });
    return scene;
  }

 private:
  /// "file:line:column: ", or the command line's.
  std::string place(std::string_view name, toml::node const& node) const {
    if (auto const set = overrides_.find(std::string(name)); set != overrides_.end())
      return set->second + ": ";
    auto const begin = node.source().begin;
    return fmt::format("{}:{}:{}: ", origin_, begin.line, begin.column);
  }

  void refuse_unknown(std::string const& name, toml::node const& node) {
    bool const is_table_name =
        std::any_of(known_.begin(), known_.end(),
                    [&](std::string const& k) { return k.starts_with(name + "."); });
    if (is_table_name && node.is_table()) {
      for (auto const& [inner, inner_node] : *node.as_table())
        refuse_unknown(name + "." + std::string(inner.str()), inner_node);
      return;
    }
    if (is_table_name)
      throw InputError(fmt::format("{}{} = {} (must be a table); write [{}]", place(name, node), name,
                                   describe(node), name));
    if (std::find(known_.begin(), known_.end(), name) != known_.end()) return;
    std::vector<std::string> candidates = known_;
    if (node.is_table() && name.find('.') == std::string::npos)  // a table is most like a table
      for (auto& key : candidates) key = key.substr(0, key.find('.'));
    throw InputError(fmt::format("{}unknown {} {}; did you mean {}?", place(name, node),
                                 node.is_table() ? "table" : "key", name,
                                 nearest_word(name, candidates)));
  }

  [[noreturn]] void refuse(Key const& key, toml::node const& node, std::string const& why) const {
    throw InputError(
        fmt::format("{}{} = {} ({}): {}", place(key.name, node), key.name, describe(node), why, key.meaning));
  }

  void refuse_other_protocol(Key const& key, toml::node const& node,
                             std::string const& protocol) const {
    if (!belongs(key, protocol))
      throw InputError(fmt::format(
          "{}{} = {} (belongs to shear.protocol = \"{}\", not \"{}\"): {}; leave it out or change "
          "shear.protocol",
          place(key.name, node), key.name, describe(node), fmt::join(key.protocols, "\" or \""),
          protocol, key.meaning));
    if (key.name == "shear.strain" && node.is_array() && protocol != "cascade")
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
    if (!text) refuse(key, node, "must be a string");
    member = text->get();
    if (key.words.empty()) return;
    if (std::find(key.words.begin(), key.words.end(), member) == key.words.end())
      refuse(key, node, fmt::format("must be one of \"{}\"", fmt::join(key.words, "\", \"")));
  }

  void take(Key const& key, toml::node const& node, bool& member) const {
    auto const* flag = node.as_boolean();
    if (!flag) refuse(key, node, "must be true or false");
    member = flag->get();
  }

  void take(Key const& key, toml::node const& node, std::int64_t& member) const {
    auto const* number = node.as_integer();
    if (!number) refuse(key, node, "must be an integer");
    member = number->get();
    in_range(key, node, static_cast<double>(member));
  }

  void take(Key const& key, toml::node const& node, double& member) const {
    if (auto const* number = node.as_floating_point())
      member = number->get();
    else if (auto const* whole = node.as_integer())
      member = static_cast<double>(whole->get());
    else
      refuse(key, node, "must be a number");
    in_range(key, node, member);
  }

  void take(Key const& key, toml::node const& node, std::optional<double>& member) const {
    auto const* text = node.as_string();
    if (text && text->get() == "auto") return member.reset();
    if (text) refuse(key, node, "must be a number or \"auto\"");
    take(key, node, member.emplace());
  }

  void take(Key const& key, toml::node const& node, NumberOrWord& member) const {
    auto const* text = node.as_string();
    if (!text) return take(key, node, (member = 0.0).number.value());
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

  void take(Key const& key, toml::node const& node, Strain& member) const {
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
  std::vector<std::string> known_;
};

/// A word that is no TOML value is a string.
void put_override(toml::table& scene, Override const& put) {
  if (put.key.find_first_not_of(
          "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.-") != std::string::npos)
    throw InputError(
        fmt::format("{}: {} is no key; write --set table.key=value", put.origin, put.key));

  toml::table parsed;
  try {
    parsed = parse_toml("value = " + put.value, put.origin);
  } catch (InputError const&) {
    if (put.value.empty() || put.value.find_first_of("\"'[]{}#=\n") != std::string::npos) throw;
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
  std::string const origin = fmt::format("--set {}", text);
  if (equals == std::string::npos || equals == 0)
    throw InputError(fmt::format("{}: write --set table.key=value", origin));
  return {text.substr(0, equals), text.substr(equals + 1), origin};
}

constexpr std::int64_t most_trajectories = 256;  // systems often allow 1024 open files

void refuse_bad_protocol(Scene const& scene, auto const& refuse) {
  auto const& shear = scene.shear;
  auto const& rates = shear.strain_rates;
  for (std::size_t k = 1; k < rates.size(); ++k)
    if (rates[k] >= rates[k - 1])
      refuse(fmt::format("shear.strain_rates = [{:g}] (each must be below the one before: it starts from "
                         "the state of the next larger); write the largest first, none twice",
                         fmt::join(rates, ", ")));
  if (shear.strain.is_list() && shear.strain.each.size() != rates.size())
    refuse(fmt::format("shear.strain = [{:g}] has {} numbers, shear.strain_rates has {} (must be as many); "
                       "give one for each rate, or one number for all",
                       fmt::join(shear.strain.each, ", "), shear.strain.each.size(), rates.size()));
  if (shear.protocol == "ramp" && shear.strain_rate_high <= shear.strain_rate)
    refuse(fmt::format("shear.strain_rate_high = {} (must be more than shear.strain_rate = {}, the lowest); "
                       "raise it",
                       shear.strain_rate_high, shear.strain_rate));
  if (!shear.target_error.empty() &&
      (scene.measure.profiles || scene.measure.fields || scene.measure.rotation))
    refuse(
        "shear.target_error does not go with measure.profiles, measure.fields or measure.rotation "
        "(where their frames begin depends on where the run ends); give shear.strain alone");
}

void refuse_contradictions(Scene const& scene, std::string const& origin) {
  auto const refuse = [&](std::string const& message) {
    throw InputError(fmt::format("{}: {}", origin, message));
  };
  auto const& disks = scene.disks;
  if (disks.count % 2 != 0)
    refuse(fmt::format(
        "disks.count = {} (must be even: half the disks are small, half big); use {} or {}",
        disks.count, disks.count - 1, disks.count + 1));
  if (disks.packing_fraction >= 1)
    refuse("disks.packing_fraction = 1 (must be below 1: disks cannot fill the plane)");
  if (disks.force_exponent != 2.0 && disks.force_exponent != 2.5)
    refuse(fmt::format("disks.force_exponent = {} (must be 2, harmonic, or 2.5, Hertz)",
                       disks.force_exponent));
  if (disks.model != "general" && (disks.damping_normal != 1 || disks.damping_tangential != 1))
    refuse(fmt::format("disks.damping_normal and disks.damping_tangential belong to model "
                       "\"general\", not \"{}\"; change disks.model or leave them out",
                       disks.model));
  if (scene.start.kind == "state" && scene.start.file.empty())
    refuse("start.file is missing: start.kind = \"state\" needs a state file");
  if (scene.start.kind == "random" && !scene.start.file.empty())
    refuse(fmt::format("start.file = \"{}\" is not used by start.kind = \"random\"; set "
                       "start.kind = \"state\" or leave it out",
                       scene.start.file));
  refuse_bad_protocol(scene, refuse);
  if (scene.shear.discard && *scene.shear.discard >= 1)
    refuse("shear.discard = 1 (must be below 1) would leave nothing to measure");
  if (scene.output.trajectory_strain > 0 && disks.replicas > most_trajectories)
    refuse(fmt::format("output.trajectory_strain = {} with disks.replicas = {} (must be at most {}: a "
                       "file is open for each); run some of the seeds at a time, or set "
                       "output.trajectory_strain = 0",
                       scene.output.trajectory_strain, disks.replicas, most_trajectories));
  if (scene.measure.correlations && !scene.measure.contacts)
    refuse("measure.correlations = true (looks at contacts, which are not followed); set "
           "measure.contacts = true, or measure.correlations = false");
  if (scene.measure.rotation && !scene.rotates())
    refuse(fmt::format("measure.rotation = true (disks of model \"{}\" do not rotate); use model "
                       "\"CD_rot\" or \"general\", or measure.rotation = false",
                       disks.model));
}

Scene scene_of(toml::table table, std::string const& origin, std::filesystem::path const& folder,
               std::vector<Override> const& overrides) {
  std::map<std::string, std::string> set;
  for (auto const& put : overrides) {
    put_override(table, put);
    set[put.key] = put.origin;
  }
  Scene scene = Reader(table, origin, set).read();
  refuse_contradictions(scene, origin);
  if (!scene.start.file.empty())
    scene.start.file =
        std::filesystem::absolute(folder / scene.start.file).lexically_normal().string();
  return scene;
}

}  // namespace

Scene parse_scene(std::string_view text, std::string const& origin,
                  std::filesystem::path const& folder,
                  std::vector<std::string> const& overrides) {
  toml::table table = parse_toml(text, origin);
  if (auto const* sweep = table.get("sweep"); sweep && sweep->is_table())
    throw InputError(fmt::format("{}:{}:{}: [sweep] makes many scenes of this one; run them all with "
                                 "`bagnold sweep {}`",
                                 origin, sweep->source().begin.line, sweep->source().begin.column,
                                 origin));
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

namespace {

std::string toml_value(std::string const& text) {
  std::string quoted = "\"";
  for (char const c : text) {
    if (c == '"' || c == '\\')
      quoted += fmt::format("\\{}", c);
    else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      quoted += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    else
      quoted += c;
  }
  return quoted + "\"";
}
std::string toml_value(bool flag) { return flag ? "true" : "false"; }
std::string toml_value(std::int64_t number) { return fmt::format("{}", number); }
std::string toml_value(double number) {
  std::string text = fmt::format("{}", number);  // shortest that reads back to the same bits
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}
std::string toml_value(std::optional<double> const& number) {
  return number ? toml_value(*number) : "\"auto\"";
}
std::string toml_value(NumberOrWord const& value) {
  return value.number ? toml_value(*value.number) : toml_value(value.word);
}
std::string toml_value(std::vector<double> const& list) {
  std::string text;
  for (double const one : list) text += (text.empty() ? "" : ", ") + toml_value(one);
  return "[" + text + "]";
}
std::string toml_value(Strain const& strain) {
  return strain.is_list() ? toml_value(strain.each) : toml_value(strain.at(0));
}
std::string toml_value(std::map<std::string, double> const& table) {
  std::string text;
  for (auto const& [name, one] : table)
    text += fmt::format("{} {} = {}", text.empty() ? "" : ",", toml_value(name), toml_value(one));
  return "{" + text + " }";
}

}  // namespace

std::string write_scene(Scene const& scene) {
  std::string text, table;
  for_each_key(scene, [&](Key const& key, auto const& member) {
    auto const dot = key.name.find('.');
    if (key.name == "start.file" && scene.start.file.empty()) return;
    if (!belongs(key, scene.shear.protocol)) return;
    if (dot != std::string_view::npos && key.name.substr(0, dot) != table) {
      table = key.name.substr(0, dot);
      text += fmt::format("\n[{}]\n", table);
    }
    auto const name = dot == std::string_view::npos ? key.name : key.name.substr(dot + 1);
    text += fmt::format("{} = {}\n", name, toml_value(member));
  });
  return text;
}

}  // namespace bagnold
