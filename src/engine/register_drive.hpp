// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/config/drives.hpp"
#include "src/engine/drives/drive_engines.hpp"

namespace bagnold {

/// Registers a one-body force of a user's program under its name. Scenes may then name it as
/// drive.kind, with every law, scheme and engine that supports the drives of the list. To be called
/// before the first scene is read, by one thread. Throws InputError if the name is taken.
template <OneBodyDrive Drive>
void register_drive() {
  register_facts({Drive::name, Drive::thermal});
  register_engines(engines_of_drive<Drive>());
}

}  // namespace bagnold
