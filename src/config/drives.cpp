// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/drives.hpp"

#include <fmt/format.h>

#include "kernels/physics/drives/drives.hpp"
#include "src/config/errors.hpp"

namespace bagnold {

namespace {

NamedEntries<DriveFacts>& drives() {
  return NamedEntries<DriveFacts>::of<Drives>([]<class Drive>() {
    return DriveFacts{Drive::name, Drive::thermal};
  });
}

}  // namespace

NamedEntries<DriveFacts> const& known_drives() { return drives(); }

void register_facts(DriveFacts const& drive) {
  if (drive.name == no_drive || drives().find(drive.name))
    throw InputError(
        fmt::format("a drive named \"{}\" is there already; give yours another name", drive.name));
  drives().add(drive);
}

}  // namespace bagnold
