// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fstream>
#include <string>

#include "src/config/errors.hpp"
#include "src/sweep/sweep.hpp"
#include "tests/io/folder.hpp"

/// Sweep files for the tests.
namespace bagnold::sweep {

inline std::string const base = R"([disks]
model = "CD"
count = 64
packing_fraction = 0.8
elasticity = 1.0
mass = "equal"
[shear]
strain_rate = 1e-3
strain = 1.0
)";

/// The base scene with a table [sweep] behind it, read from a file of its own.
inline Sweep expand(std::string const& table, std::string const& scene = base) {
  io::TestFolder folder;
  std::ofstream(folder / "sweep.toml") << scene + table;
  return read_sweep(folder / "sweep.toml", [](Scene const&, Plan const&) {});
}

/// The message with which a table is refused; "accepted" if it is not.
inline std::string refusal(std::string const& table, std::string const& scene = base) {
  try {
    expand(table, scene);
  } catch (InputError const& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace bagnold::sweep
