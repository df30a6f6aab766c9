// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/drives.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "kernels/physics/drives/drives.hpp"
#include "kernels/physics/type_list.hpp"
#include "src/config/errors.hpp"

namespace bagnold {

namespace {

std::vector<DriveFacts>& all() {
  static std::vector<DriveFacts> drives = [] {
    std::vector<DriveFacts> listed;
    for_each_type<Drives>([&]<class Drive>(std::type_identity<Drive>) {
      listed.push_back({Drive::name, Drive::thermal});
    });
    return listed;
  }();
  return drives;
}

}  // namespace

std::vector<DriveFacts> const& known_drives() { return all(); }

void know_drive(DriveFacts const& drive) {
  if (drive.name == no_drive || std::ranges::count(all(), drive.name, &DriveFacts::name) > 0)
    throw InputError(
        fmt::format("a drive named \"{}\" is there already; give yours another name", drive.name));
  all().push_back(drive);
}

}  // namespace bagnold
