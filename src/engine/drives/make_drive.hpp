// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>

#include "kernels/cpu/steps/block_drive.hpp"
#include "kernels/device/dynamics/device_drive.hpp"
#include "src/engine/drives/drive_setup.hpp"

/// The one-body force of a scene for its engine; null where none acts. Compiled once, for all laws.
namespace bagnold {

template <class Force, bool Rotates>
std::unique_ptr<BlockDrive<Force, Rotates> const> make_block_drive(
    std::optional<DriveSetup> const& setup);

template <bool Rotates, class Space>
std::unique_ptr<DeviceDrive<Rotates, Space> const> make_device_drive(
    std::optional<DriveSetup> const& setup);

}  // namespace bagnold
