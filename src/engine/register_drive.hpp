// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/config/drives.hpp"
#include "src/engine/drives/drive_engines.hpp"

namespace bagnold {

/// Makes a force on each disk alone, of a program's own, known under its name: scenes may name it
/// as drive.kind, with any law, scheme and engine that the drives of the list go with. To be called
/// before the first scene is read, by one thread. Throws InputError where the name is taken.
template <OneBodyDrive Drive>
void register_drive() {
  know_drive({Drive::name, Drive::thermal});
  add_drive_engines(engines_of_drive<Drive>());
}

}  // namespace bagnold
