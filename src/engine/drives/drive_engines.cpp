// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/drives/drive_engines.hpp"

#include <algorithm>
#include <list>

#include "kernels/physics/drives/drives.hpp"
#include "kernels/physics/type_list.hpp"

namespace bagnold {

namespace {

/// A list: what was looked up stays where it is when another drive is added.
std::list<DriveEngines>& all() {
  static std::list<DriveEngines> engines = [] {
    std::list<DriveEngines> listed;
    for_each_type<Drives>([&]<class Drive>(std::type_identity<Drive>) {
      listed.push_back(engines_of_drive<Drive>());
    });
    return listed;
  }();
  return engines;
}

}  // namespace

DriveEngines const& drive_engines(std::string_view name) {
  return *std::ranges::find(all(), name, &DriveEngines::name);
}

void add_drive_engines(DriveEngines const& engines) { all().push_back(engines); }

}  // namespace bagnold
