# SPDX-License-Identifier: BSD-3-Clause
#
# `cmake --install`: the kernel headers, and what find_package(Bagnold) needs to offer the target
# Bagnold::kernels; if the program was built it too, and with COMPONENTS run the libraries behind `bagnold run`,
# `sweep` and `analyse`, Bagnold::run, Bagnold::sweep and Bagnold::analysis, with their headers. Headers keep their
# path from the root of the repository: with Bagnold::kernels linked, #include "kernels/physics/laws/cd_n.hpp" works
# as it does here. `cmake --install BUILD --component program` leaves headers and libraries out.

include(GNUInstallDirs)
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME development)
include(CMakePackageConfigHelpers)

set(bagnold_headers "${CMAKE_INSTALL_INCLUDEDIR}/bagnold")
set(bagnold_package "${CMAKE_INSTALL_LIBDIR}/cmake/Bagnold")

target_include_directories(bagnold_kernels INTERFACE
  "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>" "$<INSTALL_INTERFACE:${bagnold_headers}>")
set_target_properties(bagnold_kernels PROPERTIES EXPORT_NAME kernels)
add_library(Bagnold::kernels ALIAS bagnold_kernels)

if(BAGNOLD_PROGRAM)
  install(TARGETS bagnold RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT program)
  install(DIRECTORY "${PROJECT_SOURCE_DIR}/inputs/" COMPONENT program
    DESTINATION "${CMAKE_INSTALL_DATADIR}/bagnold" PATTERN "checks" EXCLUDE)
  install(DIRECTORY "${PROJECT_SOURCE_DIR}/python/bagnold" COMPONENT program
    DESTINATION "${CMAKE_INSTALL_DATADIR}/bagnold/python" PATTERN "__pycache__" EXCLUDE)
  include("${CMAKE_CURRENT_LIST_DIR}/shell.cmake")
  set(bagnold_libraries config statistics io engine start measure run sweep analysis)
  foreach(name IN LISTS bagnold_libraries)
    set_target_properties(bagnold_${name} PROPERTIES EXPORT_NAME ${name})
    install(DIRECTORY "${PROJECT_SOURCE_DIR}/src/${name}" DESTINATION "${bagnold_headers}/src"
      FILES_MATCHING PATTERN "*.hpp")
  endforeach()
  install(DIRECTORY "${PROJECT_SOURCE_DIR}/src/state" DESTINATION "${bagnold_headers}/src"
    FILES_MATCHING PATTERN "*.hpp")
  target_include_directories(bagnold_options INTERFACE "$<INSTALL_INTERFACE:${bagnold_headers}>")
  set_target_properties(bagnold_options PROPERTIES EXPORT_NAME options)
  list(TRANSFORM bagnold_libraries PREPEND bagnold_)
  install(TARGETS bagnold_options ${bagnold_libraries} EXPORT BagnoldRunTargets
    ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}")
  install(EXPORT BagnoldRunTargets NAMESPACE Bagnold:: DESTINATION "${bagnold_package}")
endif()
install(DIRECTORY "${PROJECT_SOURCE_DIR}/kernels" DESTINATION "${bagnold_headers}"
  FILES_MATCHING PATTERN "*.hpp")
# Named and placed as packages of Debian have them.
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" RENAME copyright COMPONENT program
  DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/bagnold")
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" RENAME copyright
  DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/bagnold-dev")

install(TARGETS bagnold_kernels EXPORT BagnoldTargets)
install(EXPORT BagnoldTargets NAMESPACE Bagnold:: DESTINATION "${bagnold_package}")

# Where Kokkos was found for this build: the last place that the installed package looks in.
set(bagnold_kokkos_hint "${Kokkos_DIR}")
configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/BagnoldConfig.cmake.in"
  "${PROJECT_BINARY_DIR}/BagnoldConfig.cmake" INSTALL_DESTINATION "${bagnold_package}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/BagnoldConfigVersion.cmake"
  VERSION "${PROJECT_VERSION}" COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES
  "${PROJECT_BINARY_DIR}/BagnoldConfig.cmake"
  "${PROJECT_BINARY_DIR}/BagnoldConfigVersion.cmake"
  "${PROJECT_SOURCE_DIR}/cmake/kokkos_debian.cmake"
  DESTINATION "${bagnold_package}")
