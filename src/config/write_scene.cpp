// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "src/config/keys.hpp"
#include "src/config/scene_file.hpp"

namespace bagnold {

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
std::string toml_value(std::vector<SequencePiece> const& list) {
  std::string text;
  for (auto const& [rate, amount] : list)
    text +=
        fmt::format("{}[{}, {}]", text.empty() ? "" : ", ", toml_value(rate), toml_value(amount));
  return "[" + text + "]";
}
std::string toml_value(NumberOrList const& strain) {
  return strain.is_list() ? toml_value(strain.each) : toml_value(strain.at(0));
}
std::string toml_value(std::map<std::string, double> const& table) {
  std::string text;
  for (auto const& [name, one] : table)
    text += fmt::format("{} {} = {}", text.empty() ? "" : ",", toml_value(name), toml_value(one));
  return "{" + text + " }";
}

}  // namespace

std::vector<std::pair<std::string, std::string>> written_keys(Scene const& scene) {
  std::vector<std::pair<std::string, std::string>> keys;
  for_each_key(scene, [&](Key const& key, auto const& member) {
    if (key.name == "start.file" && scene.start.file.empty()) return;
    if (belongs(key, scene.shear.protocol)) keys.emplace_back(key.name, toml_value(member));
  });
  return keys;
}

std::string write_scene(Scene const& scene) {
  std::string text, table;
  for (auto const& [key, value] : written_keys(scene)) {
    auto const dot = key.find('.');
    if (dot != std::string::npos && key.substr(0, dot) != table) {
      table = key.substr(0, dot);
      text += fmt::format("\n[{}]\n", table);
    }
    text += fmt::format("{} = {}\n", dot == std::string::npos ? key : key.substr(dot + 1), value);
  }
  return text;
}

}  // namespace bagnold
