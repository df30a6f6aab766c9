// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/figures/figure_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "src/config/errors.hpp"
#include "src/config/nearest_word.hpp"
#include "src/config/shipped_inputs.hpp"
#include "src/config/toml_text.hpp"

namespace bagnold::analysis {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

std::string text_of(json const& value) {
  return value.is_string() ? value.get<std::string>() : value.dump();
}

/// Puts values for {NAME} in texts; a text that is nothing but {NAME} becomes the value. Other
/// braces belong to formulas.
json filled(json const& node, json const& values) {
  if (node.is_structured()) {
    json out = node;
    for (auto& part : out) part = filled(part, values);
    return out;
  }
  if (!node.is_string()) return node;
  std::string text = node.get<std::string>();
  for (auto const& [name, value] : values.items()) {
    auto const sign = "{" + name + "}";
    if (text == sign) return value;
    for (auto at = text.find(sign); at != std::string::npos; at = text.find(sign, at))
      text.replace(at, sign.size(), text_of(value));
  }
  return text;
}

bool kept(json const& entry, bool quick) { return !quick || entry.value("quick", true); }

/// Data sets of a panel, one or several; in the quick version their substitutes.
std::vector<std::string> data_of(json const& entry, json const& figure, bool quick) {
  json const given = entry.value("data", figure.value("data", json::array()));
  std::vector<std::string> out;
  auto const take = [&](std::string const& name) {
    if (!name.empty() && std::ranges::find(out, name) == out.end()) out.push_back(name);
  };
  for (auto const& name : given.is_array() ? given : json::array({given})) {
    if (!quick) {
      take(name);
      continue;
    }
    auto const& instead = figure.at("quick").at("data");
    take(instead.is_string() ? instead.get<std::string>()
                             : instead.value(name.get<std::string>(), ""));
  }
  return out;
}

/// "P2-8" before "P2-10".
std::pair<std::string, int> order(std::string const& name) {
  auto const dash = name.find('-');
  return {name.substr(0, dash), std::atoi(name.c_str() + dash + 1)};
}

}  // namespace

FigureFile::FigureFile(fs::path const& file) : file_(file) {
  figures_ = json::parse(toml_as_json(read_text(file), file.string()));
}

std::vector<std::string> FigureFile::names() const {
  std::vector<std::string> names;
  for (auto const& [name, figure] : figures_.items()) names.push_back(name);
  std::ranges::sort(names, {}, order);
  return names;
}

bool FigureFile::has_quick(std::string const& name) const {
  return figures_.at(name).contains("quick");
}

fs::path FigureFile::sweep(std::string const& data) const {
  return file_.parent_path() / (data + ".toml");
}

Figure FigureFile::read(std::string const& name, bool quick) const try {
  if (!figures_.contains(name))
    throw InputError(fmt::format("figure {} (not in {}){} `bagnold figure` lists all", name,
                                 file_.string(), did_you_mean(name, names(), ".")));
  json const& found = figures_.at(name);
  if (quick && !found.contains("quick"))
    throw InputError(fmt::format("figure {} --quick: there is no quick version of it", name));
  json values = found.value("values", json::object());
  if (quick) values.update(found.at("quick").value("values", json::object()));

  Figure figure{.name = name,
                .title = found.at("title"),
                .claims = found.at("claims"),
                .remark = found.value("remark", ""),
                .hours = found.value("hours", 0.0),
                .data = {},
                .panels = {},
                .stated = {},
                .layout = {}};
  auto const take = [&](char const* key, json& to) {
    to = json::array();
    for (auto const& entry : found.value(key, json::array())) {
      auto const data = data_of(entry, found, quick);
      if (!kept(entry, quick) || (quick && data.empty())) continue;
      if (data.empty())
        throw InputError(fmt::format("{}: a {} has no data; name a sweep file", name, key));
      to.push_back(filled(entry, values));
      to.back()["data"] = data;
      for (auto const& name : data)
        if (std::ranges::find(figure.data, name) == figure.data.end()) figure.data.push_back(name);
    }
  };
  take("panel", figure.panels);
  take("stated", figure.stated);
  if (figure.panels.empty()) throw InputError(fmt::format("{}: has no panel", name));
  figure.layout = found;
  for (auto const* key : {"panel", "stated", "values", "quick", "data", "claims", "hours"})
    figure.layout.erase(key);
  if (quick) figure.layout.update(found.at("quick").value("layout", json::object()));
  return figure;
} catch (json::exception const& error) {
  throw InputError(fmt::format("{}: {}: {}", file_.string(), name, error.what()));
}

fs::path find_figure_file(fs::path const& given) {
  if (!given.empty()) return given;
  if (auto const file = find_shipped_input("figures/figures.toml")) return *file;
  throw InputError("inputs/figures/figures.toml is not here; name it with --figures FILE");
}

}  // namespace bagnold::analysis
