// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/cli/commands.hpp"

/// Options shared by several commands. The variables that they are read into must outlive the
/// parsing.
namespace bagnold {

/// Text on units and exit codes in `bagnold --help` and in the help of each command.
extern char const* const units_and_exit_codes;

/// A command with these words, and with units and exit codes below its help.
Words add_command(Words program, char const* name, char const* description);

void add_machine_options(Words command, Machine& machine, bool& quiet);
void add_scene_options(Words command, SceneOptions& options);

/// --format, of pictures: png, pdf or svg.
void add_picture_format(Words command, std::string& format);

/// --allow-unstable.
void add_unstable_flag(Words command, bool& allow_unstable);

}  // namespace bagnold
