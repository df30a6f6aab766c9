# SPDX-License-Identifier: BSD-3-Clause
#
# Finds Kokkos, 3.4 to 5.x, with whatever backends it has. Looked for, in this order: Kokkos_ROOT and
# CMAKE_PREFIX_PATH, the usual places, the cache that scripts/quickstart fills, and last, where
# BAGNOLD_FETCH_KOKKOS is on, upstream's release. Leaves the target Kokkos::kokkos, Kokkos_VERSION and
# Kokkos_DEVICES (such as "OPENMP;SERIAL").

option(BAGNOLD_FETCH_KOKKOS "Download and build Kokkos where none is found" OFF)

# The same folder as in scripts/lib/kokkos.sh.
if(DEFINED ENV{BAGNOLD_CACHE})
  set(bagnold_cache "$ENV{BAGNOLD_CACHE}")
elseif(DEFINED ENV{XDG_CACHE_HOME})
  set(bagnold_cache "$ENV{XDG_CACHE_HOME}/bagnold")
else()
  set(bagnold_cache "$ENV{HOME}/.cache/bagnold")
endif()
file(GLOB bagnold_cached_kokkos "${bagnold_cache}/kokkos-*-${CMAKE_SYSTEM_PROCESSOR}-*")
list(SORT bagnold_cached_kokkos COMPARE NATURAL ORDER DESCENDING)  # the newest first

# No version is asked for here: Kokkos' own version files accept one major version only.
find_package(Kokkos QUIET PATHS ${bagnold_cached_kokkos})

if(Kokkos_FOUND)
  if(Kokkos_VERSION VERSION_LESS 3.4)
    set(bagnold_old_kokkos "${Kokkos_DIR}")
    unset(Kokkos_DIR CACHE)  # so that the next try looks again
    message(FATAL_ERROR "Kokkos ${Kokkos_VERSION} in ${bagnold_old_kokkos} is too old (3.4 to 5.x are "
      "supported). Point CMake at another with -DKokkos_ROOT=PREFIX.")
  elseif(Kokkos_VERSION VERSION_GREATER_EQUAL 6)
    message(WARNING "Kokkos ${Kokkos_VERSION} is newer than what Bagnold was tested with (3.4 to 5.x).")
  endif()
  include("${CMAKE_CURRENT_LIST_DIR}/kokkos_debian.cmake")
  include("${CMAKE_CURRENT_LIST_DIR}/kokkos_runs.cmake")
  bagnold_refuse_new_views()
  bagnold_try_kokkos()
  message(STATUS "Kokkos ${Kokkos_VERSION} with ${Kokkos_DEVICES} in ${Kokkos_DIR}")

elseif(BAGNOLD_FETCH_KOKKOS)
  include(FetchContent)
  set(Kokkos_ENABLE_SERIAL ON CACHE BOOL "")
  set(Kokkos_ENABLE_OPENMP ON CACHE BOOL "")
  message(STATUS "Kokkos 4.5.01 with OPENMP;SERIAL: upstream's release, downloaded")
  # What `git archive` gives for tag 4.5.01, commit 175257a51ff29a0059ec48bcd233ee096b2c0438.
  FetchContent_Declare(Kokkos SYSTEM
    URL https://github.com/kokkos/kokkos/releases/download/4.5.01/kokkos-4.5.01.tar.gz
    URL_HASH SHA256=52d003ffbbe05f30c89966e4009c017efb1662b02b2b73190670d3418719564c)
  FetchContent_MakeAvailable(Kokkos)
  set(Kokkos_VERSION 4.5.01)  # not before: Kokkos' own build refuses such variables from outside
  set(Kokkos_DEVICES OPENMP SERIAL)

else()
  message(FATAL_ERROR "Kokkos (3.4 to 5.x) was not found. Do one of these:\n"
    "  * on Debian 12, run scripts/quickstart once: it builds Debian's Kokkos into ${bagnold_cache};\n"
    "  * point CMake at an installed Kokkos with -DKokkos_ROOT=PREFIX;\n"
    "  * let CMake download and build upstream's release with -DBAGNOLD_FETCH_KOKKOS=ON.\n")
endif()
