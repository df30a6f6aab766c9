// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/drives/make_drive.hpp"

#include "kernels/physics/drives/drives.hpp"
#include "kernels/physics/type_list.hpp"
#include "src/engine/backends.hpp"

namespace bagnold {

template <class Force, bool Rotates>
std::unique_ptr<BlockDrive<Force, Rotates> const> make_block_drive(
    std::optional<DriveSetup> const& setup) {
  using Made = std::unique_ptr<BlockDrive<Force, Rotates> const>;
  if (!setup) return nullptr;
  return with_named<Drives>(setup->kind, [&]<class Drive>(std::type_identity<Drive>) -> Made {
    return std::make_unique<DriveOnBlocks<Drive, Force, Rotates>>(setup->input, setup->stream);
  });
}

template <bool Rotates, class Space>
std::unique_ptr<DeviceDrive<Rotates, Space> const> make_device_drive(
    std::optional<DriveSetup> const& setup) {
  using Made = std::unique_ptr<DeviceDrive<Rotates, Space> const>;
  if (!setup) return nullptr;
  return with_named<Drives>(setup->kind, [&]<class Drive>(std::type_identity<Drive>) -> Made {
    return std::make_unique<DriveOnDevice<Drive, Rotates, Space>>(setup->input, setup->stream);
  });
}

#define BAGNOLD_BLOCK_DRIVE(Force, rotates)                                    \
  template std::unique_ptr<BlockDrive<Force, rotates> const> make_block_drive( \
      std::optional<DriveSetup> const&)
BAGNOLD_BLOCK_DRIVE(simd::Force, false);
BAGNOLD_BLOCK_DRIVE(simd::TurningForce, false);
BAGNOLD_BLOCK_DRIVE(simd::TurningForce, true);
#undef BAGNOLD_BLOCK_DRIVE

#define BAGNOLD_DEVICE_DRIVE(Space)                                            \
  template std::unique_ptr<DeviceDrive<false, Space> const> make_device_drive( \
      std::optional<DriveSetup> const&);                                       \
  template std::unique_ptr<DeviceDrive<true, Space> const> make_device_drive(  \
      std::optional<DriveSetup> const&)
#ifdef KOKKOS_ENABLE_SERIAL
BAGNOLD_DEVICE_DRIVE(Kokkos::Serial);
#endif
#if defined(KOKKOS_ENABLE_OPENMP) && defined(BAGNOLD_BACKEND_OPENMP)
BAGNOLD_DEVICE_DRIVE(Kokkos::OpenMP);
#endif
#if defined(KOKKOS_ENABLE_CUDA) && defined(BAGNOLD_BACKEND_CUDA)
BAGNOLD_DEVICE_DRIVE(Kokkos::Cuda);
#endif
#undef BAGNOLD_DEVICE_DRIVE

}  // namespace bagnold
