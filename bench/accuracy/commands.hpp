// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

namespace bagnold::accuracy {

/// Each adds a subcommand that prints a table as CSV.
void add_collision(CLI::App& app);
void add_stability(CLI::App& app);
void add_steady(CLI::App& app);
void add_stretch(CLI::App& app);

}  // namespace bagnold::accuracy
