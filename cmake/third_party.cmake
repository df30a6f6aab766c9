# SPDX-License-Identifier: BSD-3-Clause
#
# Libraries from third_party/, which scripts/wheel puts into the source distribution for pip: nothing else is looked
# for then, all of it becomes part of the program, and what that needs of a system is its C library.
set(bagnold_third_party "${PROJECT_SOURCE_DIR}/third_party")

# bagnold_part(NAME): a library by its own build, of which nothing is installed.
function(bagnold_part name)
  set(CMAKE_POLICY_DEFAULT_CMP0077 NEW)
  set(CMAKE_WARN_DEPRECATED OFF)
  set(BUILD_SHARED_LIBS OFF)
  add_subdirectory("${bagnold_third_party}/${name}" "${PROJECT_BINARY_DIR}/third_party/${name}" EXCLUDE_FROM_ALL)
endfunction()

set(Kokkos_ENABLE_SERIAL ON CACHE BOOL "")
set(Kokkos_ENABLE_OPENMP ON CACHE BOOL "")
bagnold_part(kokkos)
set(Kokkos_DEVICES OPENMP SERIAL)

# What the program asks of HDF5 is files, from several threads: no filters, no network.
foreach(off IN ITEMS BUILD_TESTING HDF5_BUILD_TOOLS HDF5_BUILD_UTILS HDF5_BUILD_EXAMPLES HDF5_BUILD_HL_LIB
    HDF5_ENABLE_Z_LIB_SUPPORT HDF5_ENABLE_SZIP_SUPPORT HDF5_ENABLE_ROS3_VFD)
  set(${off} OFF CACHE BOOL "")
endforeach()
set(HDF5_ENABLE_THREADSAFE ON CACHE BOOL "")
set(HDF5_EXTERNALLY_CONFIGURED 1)
# Digits of long double, and of a type that only Fortran asks for: HDF5 1.10.8 looks for the file that its trial program
# writes where CMake 3.25 and newer do not run it.
file(WRITE "${CMAKE_BINARY_DIR}/pac_Cconftest.out" "21;0;")
set(HDF5_EXPORTED_TARGETS hdf5-targets)
bagnold_part(hdf5)
add_library(hdf5::hdf5 INTERFACE IMPORTED GLOBAL)
target_link_libraries(hdf5::hdf5 INTERFACE hdf5-static)
target_include_directories(hdf5::hdf5 SYSTEM INTERFACE "${bagnold_third_party}/hdf5/src"
  "${PROJECT_BINARY_DIR}/third_party/hdf5")

bagnold_part(fmt)

# Headers alone.
set(RANDOM123_INCLUDE_DIR "${bagnold_third_party}/include")
set(XXHASH_INCLUDE_DIR "${bagnold_third_party}/include")
set(XXHASH_LIBRARY bagnold_xxhash)
add_library(bagnold_xxhash INTERFACE)
target_compile_definitions(bagnold_xxhash INTERFACE XXH_INLINE_ALL)
foreach(target IN ITEMS Eigen3::Eigen tomlplusplus::tomlplusplus CLI11::CLI11 nlohmann_json::nlohmann_json)
  add_library(${target} INTERFACE IMPORTED GLOBAL)
  target_include_directories(${target} SYSTEM INTERFACE "${bagnold_third_party}/include")
endforeach()
target_include_directories(Eigen3::Eigen SYSTEM INTERFACE "${bagnold_third_party}/include/eigen3")

# The runtimes of C++ and OpenMP too. The compiler names its shared libgomp behind this one: nothing is left for it.
execute_process(COMMAND "${CMAKE_CXX_COMPILER}" -print-file-name=libgomp.a OUTPUT_VARIABLE bagnold_gomp
  OUTPUT_STRIP_TRAILING_WHITESPACE)
set(bagnold_runtime_sources "${PROJECT_SOURCE_DIR}/packaging/wheel/arc4random.c")
set(bagnold_runtimes -static-libstdc++ -static-libgcc "LINKER:--as-needed,--whole-archive,${bagnold_gomp},--no-whole-archive")
