# SPDX-License-Identifier: BSD-3-Clause
#
# Toolchain file: for 64-bit ARM on another machine, its programs run by qemu-user. scripts/aarch64 makes the
# folder of Debian's libraries for ARM that it needs, and Kokkos beside it.

if(DEFINED ENV{BAGNOLD_CACHE})
  set(bagnold_cache "$ENV{BAGNOLD_CACHE}")
elseif(DEFINED ENV{XDG_CACHE_HOME})
  set(bagnold_cache "$ENV{XDG_CACHE_HOME}/bagnold")
else()
  set(bagnold_cache "$ENV{HOME}/.cache/bagnold")
endif()

set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_SYSROOT "${bagnold_cache}/aarch64")
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc-12)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++-12)
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64-static -L "${CMAKE_SYSROOT}")

set(CMAKE_FIND_ROOT_PATH "${bagnold_cache}")  # Kokkos
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
foreach(kind IN ITEMS LIBRARY INCLUDE PACKAGE)
  set(CMAKE_FIND_ROOT_PATH_MODE_${kind} ONLY)
endforeach()

# Not asked: h5cc, which tells of the HDF5 of this machine.
set(HDF5_C_COMPILER_EXECUTABLE OFF CACHE STRING "")
set(CMAKE_INCLUDE_PATH /usr/include/hdf5/serial)
set(CMAKE_LIBRARY_PATH /usr/lib/aarch64-linux-gnu/hdf5/serial)
