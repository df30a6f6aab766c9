# SPDX-License-Identifier: BSD-3-Clause
#
# The libraries of the program beside Kokkos. Header-only ones that are not found are downloaded where
# BAGNOLD_FETCH_LIBRARIES is on; HDF5, fmt and xxHash are to be installed. A program linked to Bagnold::run
# (cmake/install.cmake) finds installed ones only.

option(BAGNOLD_FETCH_LIBRARIES "Download Eigen, toml++, CLI11, nlohmann_json and Random123 where they are not found" OFF)
include(FetchContent)

# bagnold_headers(NAME DEBIAN FOLDER URL SHA256): asked where NAME was not found. Leaves in bagnold_fetched the
# include folder of the download; its own build is not looked at.
function(bagnold_headers name debian folder url hash)
  if(NOT BAGNOLD_FETCH_LIBRARIES)
    message(FATAL_ERROR "${name} was not found. Do one of these:\n"
      "  * install it (Debian: ${debian});\n"
      "  * point CMake at it with -DCMAKE_PREFIX_PATH=PREFIX;\n"
      "  * let CMake download it with -DBAGNOLD_FETCH_LIBRARIES=ON.\n")
  endif()
  message(STATUS "${name}: downloaded from ${url}")
  FetchContent_Declare(${name} URL "${url}" URL_HASH SHA256=${hash} SOURCE_SUBDIR none)
  FetchContent_MakeAvailable(${name})
  string(TOLOWER "${name}" name)
  set(bagnold_fetched "${${name}_SOURCE_DIR}/${folder}" PARENT_SCOPE)
endfunction()

# bagnold_library(NAME TARGET ARGUMENT...): finds the package NAME, or makes TARGET of its headers.
function(bagnold_library name target)
  find_package(${name} QUIET)
  if(NOT TARGET ${target})
    bagnold_headers(${name} ${ARGN})
    add_library(${target} INTERFACE IMPORTED GLOBAL)
    target_include_directories(${target} SYSTEM INTERFACE "${bagnold_fetched}")
  endif()
endfunction()

find_package(HDF5 REQUIRED COMPONENTS C)
find_package(fmt REQUIRED)
find_path(XXHASH_INCLUDE_DIR xxhash.h REQUIRED)
find_library(XXHASH_LIBRARY xxhash REQUIRED)

# Versions and sums of upstream's releases.
bagnold_library(Eigen3 Eigen3::Eigen libeigen3-dev .
  https://gitlab.com/libeigen/eigen/-/archive/3.4.0/eigen-3.4.0.tar.gz
  8586084f71f9bde545ee7fa6d00288b264a2b7ac3607b974e54d13e7162c1c72)
bagnold_library(tomlplusplus tomlplusplus::tomlplusplus libtomlplusplus-dev include
  https://github.com/marzer/tomlplusplus/archive/refs/tags/v3.4.0.tar.gz
  8517f65938a4faae9ccf8ebb36631a38c1cadfb5efa85d9a72e15b9e97d25155)
bagnold_library(CLI11 CLI11::CLI11 libcli11-dev include
  https://github.com/CLIUtils/CLI11/archive/v2.4.2.tar.gz
  f2d893a65c3b1324c50d4e682c0cdc021dd0477ae2c048544f39eed6654b699a)
bagnold_library(nlohmann_json nlohmann_json::nlohmann_json nlohmann-json3-dev include
  https://github.com/nlohmann/json/archive/v3.11.3.tar.gz
  0d8ef5af7f9794e3263480193c491549b2ba6cc74bb018906202ada498a79406)
find_path(RANDOM123_INCLUDE_DIR Random123/philox.h)
if(NOT RANDOM123_INCLUDE_DIR)
  bagnold_headers(Random123 librandom123-dev include
    https://github.com/DEShawResearch/random123/archive/refs/tags/v1.14.0.tar.gz
    effafd8656b18030b2a5b995cd3650c51a7c45052e6e1c21e48b9fa7a59d926e)
  set(RANDOM123_INCLUDE_DIR "${bagnold_fetched}")
endif()
