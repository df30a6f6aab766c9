// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/drives/drive_engines.hpp"

#include "kernels/physics/drives/drives.hpp"
#include "kernels/physics/named_entries.hpp"

namespace bagnold {

namespace {

NamedEntries<DriveEngines>& engines() {
  return NamedEntries<DriveEngines>::of<Drives>(
      []<class Drive>() { return engines_of_drive<Drive>(); });
}

}  // namespace

DriveEngines const& drive_engines(std::string_view name) { return *engines().find(name); }

void register_engines(DriveEngines const& added) { engines().add(added); }

}  // namespace bagnold
