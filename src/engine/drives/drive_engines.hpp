// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <tuple>

#ifndef __CUDA_ARCH__  // of the host alone (cmake/host_only.cmake)
#include "kernels/cpu/steps/block_drive.hpp"
#endif
#include "kernels/device/dynamics/device_drive.hpp"
#include "src/engine/backends.hpp"
#include "src/engine/drives/drive_setup.hpp"

namespace bagnold {

namespace simd {
struct Force;
struct TurningForce;
}  // namespace simd
template <class Force, bool Rotates>
class BlockDrive;

template <class Force, bool Rotates>
using MakeBlockDrive = std::unique_ptr<BlockDrive<Force, Rotates> const> (*)(DriveSetup const&);

template <bool Rotates, class Space>
using MakeDeviceDrive = std::unique_ptr<DeviceDrive<Rotates, Space> const> (*)(DriveSetup const&);

namespace detail {

template <class>
struct DriveMakers;

/// On blocks, and by launches on each backend.
template <class... Spaces>
struct DriveMakers<std::tuple<Spaces...>> {
  using All =
      std::tuple<MakeBlockDrive<simd::Force, false>, MakeBlockDrive<simd::TurningForce, false>,
                 MakeBlockDrive<simd::TurningForce, true>, MakeDeviceDrive<false, Spaces>...,
                 MakeDeviceDrive<true, Spaces>...>;
};

template <OneBodyDrive Drive, class Force, bool Rotates>
void set(MakeBlockDrive<Force, Rotates>& make);

#ifndef __CUDA_ARCH__
template <OneBodyDrive Drive, class Force, bool Rotates>
void set(MakeBlockDrive<Force, Rotates>& make) {
  make = [](DriveSetup const& setup) -> std::unique_ptr<BlockDrive<Force, Rotates> const> {
    return std::make_unique<DriveOnBlocks<Drive, Force, Rotates>>(setup.input, setup.stream);
  };
}
#endif

template <OneBodyDrive Drive, bool Rotates, class Space>
void set(MakeDeviceDrive<Rotates, Space>& make) {
  make = [](DriveSetup const& setup) -> std::unique_ptr<DeviceDrive<Rotates, Space> const> {
    return std::make_unique<DriveOnDevice<Drive, Rotates, Space>>(setup.input, setup.stream);
  };
}

}  // namespace detail

/// Functions compiled for each drive, whatever the law.
struct DriveEngines {
  std::string_view name;
  detail::DriveMakers<Backends>::All makers;
};

template <OneBodyDrive Drive>
DriveEngines engines_of_drive() {
  DriveEngines engines{Drive::name, {}};
  std::apply([](auto&... make) { (detail::set<Drive>(make), ...); }, engines.makers);
  return engines;
}

/// Functions of a drive by its name: of the list in kernels/physics/drives/drives.hpp, or
/// registered.
DriveEngines const& drive_engines(std::string_view name);

/// Registers a drive (register_drive.hpp), under a name that is not taken.
void register_engines(DriveEngines const& added);

/// The drive of a scene for steps on blocks; null where none acts.
template <class Force, bool Rotates>
std::unique_ptr<BlockDrive<Force, Rotates> const> make_block_drive(
    std::optional<DriveSetup> const& setup) {
  if (!setup) return nullptr;
  return std::get<MakeBlockDrive<Force, Rotates>>(drive_engines(setup->kind).makers)(*setup);
}

/// The drive of a scene for the plain engine; null where none acts.
template <bool Rotates, class Space>
std::unique_ptr<DeviceDrive<Rotates, Space> const> make_device_drive(
    std::optional<DriveSetup> const& setup) {
  if (!setup) return nullptr;
  return std::get<MakeDeviceDrive<Rotates, Space>>(drive_engines(setup->kind).makers)(*setup);
}

}  // namespace bagnold
