// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "src/cli/exit_code.hpp"
#include "src/cli/options.hpp"
#include "src/config/keys.hpp"
#include "src/io/atomic_file.hpp"

namespace bagnold {

namespace {

using Json = nlohmann::ordered_json;

Json words_of(Key const& key) {
  Json words = Json::array();
  for (auto const word : key.words) words.push_back(word);
  return {{"enum", words}};
}

Json number_of(Key const& key, char const* type) {
  Json made = {{"type", type}};
  if (std::isfinite(key.least)) made[key.open_below ? "exclusiveMinimum" : "minimum"] = key.least;
  if (std::isfinite(key.most)) made["maximum"] = key.most;
  return made;
}

// Values that a key accepts, by the type of the member that it is read into.
Json form_of(Key const& key, std::string const&) {
  return key.words.empty() ? Json{{"type", "string"}} : words_of(key);
}
Json form_of(Key const&, bool) { return {{"type", "boolean"}}; }
Json form_of(Key const& key, std::int64_t) { return number_of(key, "integer"); }
Json form_of(Key const& key, double) { return number_of(key, "number"); }
Json form_of(Key const& key, std::optional<double> const&) {
  return {{"anyOf", {number_of(key, "number"), {{"const", automatic}}}}};
}
Json form_of(Key const& key, NumberOrWord const&) {
  return {{"anyOf", {number_of(key, "number"), words_of(key)}}};
}
Json form_of(Key const& key, std::vector<double> const&) {
  return {{"type", "array"}, {"items", number_of(key, "number")}, {"minItems", 1}};
}
Json form_of(Key const& key, std::vector<SequencePiece> const&) {
  Json const pair = {{"type", "array"},
                     {"items",
                      {number_of(key, "number"),
                       {{"type", "number"}, {"exclusiveMinimum", 0}, {"maximum", 1e12}}}},
                     {"minItems", 2},
                     {"maxItems", 2}};
  return {{"type", "array"}, {"items", pair}, {"minItems", 1}};
}
Json form_of(Key const& key, NumberOrList const&) {
  return {{"anyOf", {number_of(key, "number"), form_of(key, std::vector<double>())}}};
}
Json form_of(Key const& key, std::map<std::string, double> const&) {
  return {{"type", "object"}, {"additionalProperties", number_of(key, "number")}};
}

// Default value of a key.
Json value_of(std::optional<double> const& value) { return value ? Json(*value) : Json(automatic); }
Json value_of(NumberOrWord const& value) {
  return value.number ? Json(*value.number) : Json(value.word);
}
Json value_of(std::vector<SequencePiece> const&) { return Json::array(); }
Json value_of(NumberOrList const& value) { return value.each.front(); }
template <class T>
Json value_of(T const& value) {
  return value;
}

Json table(std::string const& what) {
  return {{"type", "object"},
          {"description", what},
          {"additionalProperties", false},
          {"properties", Json::object()}};
}

/// Keys that a protocol requires.
std::set<std::string_view> required_keys() {
  std::set<std::string_view> protocols, keys;
  Scene scene;
  for_each_key(scene, [&](Key const& key, auto const&) {
    protocols.insert(key.protocols.begin(), key.protocols.end());
  });
  for (auto const protocol : protocols) {
    scene.shear.protocol = protocol;
    for_each_key(scene, [&](Key const& key, auto const&) {
      if (key.required) keys.insert(key.name);
    });
  }
  return keys;
}

/// JSON Schema of scenes and sweep files, from the list of keys.
Json schema() {
  Json all = {{"$schema", "http://json-schema.org/draft-07/schema#"},
              {"title", "A scene of Bagnold, or a sweep of scenes"}};
  all.update(table("Units: length d_s, time tau_e, mass m, so that k_e = 1"));
  Json needed = Json::object();  // keys by their tables
  Scene const usual;
  auto const required = required_keys();
  for_each_key(usual, [&](Key const& key, auto const& member) {
    auto const dot = key.name.find('.');
    bool const in_table = dot != std::string_view::npos;
    std::string const name(in_table ? key.name.substr(dot + 1) : key.name);
    std::string const folder(in_table ? key.name.substr(0, dot) : "");
    auto& tables = all["properties"];
    if (in_table && !tables.contains(folder)) tables[folder] = table("[" + folder + "]");
    Json made = form_of(key, member);
    made["description"] =
        fmt::format("{}{}{}", key.meaning, key.unit.empty() ? "" : fmt::format(" [{}]", key.unit),
                    key.protocols.empty()
                        ? ""
                        : fmt::format("; of the protocol{} {}", key.protocols.size() > 1 ? "s" : "",
                                      fmt::join(key.protocols, ", ")));
    if (key.required && key.protocols.empty() && folder == "disks")
      needed[folder].push_back(name);
    else if (!required.contains(key.name))
      made["default"] = value_of(member);
    (in_table ? tables[folder]["properties"] : tables)[name] = made;
  });
  all["properties"]["sweep"] = {{"type", "object"}, {"description", "[sweep]: grid, zip, chain"}};
  // a sweep may give any key for each of its points
  Json then = {{"required", Json::array()}, {"properties", Json::object()}};
  for (auto const& [folder, names] : needed.items()) {
    then["required"].push_back(folder);
    then["properties"][folder] = {{"required", names}};
  }
  all["if"] = {{"not", {{"required", {"sweep"}}}}};
  all["then"] = then;
  return all;
}

}  // namespace

Command add_schema(Words program) {
  auto const file = std::make_shared<std::filesystem::path>();
  Words command = add_command(program, "schema",
                              "what keys a scene may have, as JSON Schema, for editors of TOML");
  command.option("--out", *file, "file [the screen]");
  return {command, [file] {
            auto const text = schema().dump(1) + "\n";
            if (file->empty())
              fmt::print("{}", text);
            else
              io::replace_text(*file, text);
            return done;
          }};
}

}  // namespace bagnold
