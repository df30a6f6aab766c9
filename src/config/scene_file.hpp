// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "src/config/scene.hpp"

namespace bagnold {

/// Read a scene file, put `overrides` ("table.key=value", the value in TOML, a bare word a string)
/// over it and check it. Throws InputError with file, line and column; FileError never: a scene
/// that cannot be read is bad input.
Scene read_scene(std::filesystem::path const& file, std::vector<std::string> const& overrides = {});

/// Reads the scene that a run keeps in its folder. A pipe in its place, of which nobody may write
/// the other end, is refused, where read_scene waits: a user may give a scene by a pipe.
Scene read_kept_scene(std::filesystem::path const& file);

/// A scene as TOML text that reads back to the same scene, bit for bit; with `derived` values of
/// interest as comments.
std::string write_scene(Scene const& scene);

/// The keys of that text, "table.key", and their values in TOML, in its order.
std::vector<std::pair<std::string, std::string>> written_keys(Scene const& scene);

/// Reads a scene from text. `origin` names the text in messages; start.file is relative to
/// `folder`.
Scene parse_scene(std::string_view text, std::string const& origin,
                  std::filesystem::path const& folder,
                  std::vector<std::string> const& overrides = {});

/// A value put over a scene.
struct Override {
  std::string key;     ///< "table.key"
  std::string value;   ///< in TOML
  std::string origin;  ///< where it was given, for messages
};

/// The scene of one point of a sweep file: its text without the table [sweep], `values` over it.
Scene parse_point(std::string_view text, std::string const& origin,
                  std::filesystem::path const& folder, std::vector<Override> const& values);

}  // namespace bagnold
