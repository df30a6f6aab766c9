// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "kernels/physics/named_entries.hpp"

namespace bagnold {

/// The word for none.
inline constexpr char no_drive[] = "none";

/// What reading and checking a scene asks of a drive.
struct DriveFacts {
  std::string_view name;
  bool thermal;  ///< takes drive.temperature
};

/// Of all drives: those of the list in kernels/physics/drives/drives.hpp, then those registered.
NamedEntries<DriveFacts> const& known_drives();

/// Adds a drive (src/engine/register_drive.hpp). Throws InputError where the name is taken.
void know_drive(DriveFacts const& drive);

}  // namespace bagnold
