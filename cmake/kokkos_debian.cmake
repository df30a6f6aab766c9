# SPDX-License-Identifier: BSD-3-Clause
#
# Included after find_package(Kokkos), here and in BagnoldConfig.cmake. Debian's own build of Kokkos
# (libtrilinos-kokkos-dev) gives Kokkos::kokkos an include folder that does not exist, which CMake
# refuses; the right one is in Kokkos_INCLUDE_DIRS.
if(TARGET Kokkos::kokkos AND Kokkos_INCLUDE_DIRS)
  get_target_property(bagnold_kokkos_includes Kokkos::kokkos INTERFACE_INCLUDE_DIRECTORIES)
  if(bagnold_kokkos_includes AND NOT EXISTS "${bagnold_kokkos_includes}")
    set_target_properties(Kokkos::kokkos PROPERTIES
      INTERFACE_INCLUDE_DIRECTORIES "${Kokkos_INCLUDE_DIRS}")
  endif()
endif()
