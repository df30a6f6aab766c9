// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "kernels/physics/named_entries.hpp"

namespace bagnold {

/// Word for no drive.
inline constexpr char no_drive[] = "none";

/// Facts on a drive for reading and checking a scene.
struct DriveFacts {
  std::string_view name;
  bool thermal;  ///< takes drive.temperature
};

/// Facts on all drives: first those of the list in kernels/physics/drives/drives.hpp, then
/// registered ones.
NamedEntries<DriveFacts> const& known_drives();

/// Registers a drive (src/engine/register_drive.hpp). Throws InputError where the name is taken.
void register_facts(DriveFacts const& drive);

}  // namespace bagnold
