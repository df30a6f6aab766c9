# SPDX-License-Identifier: BSD-3-Clause
#
# What pip puts into an environment beside the Python package (pyproject.toml): the program into its bin/, scenes,
# completion and manual pages into its share/.
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME program)
include(GNUInstallDirs)
if(NOT SKBUILD)  # from the source distribution by hand
  set(SKBUILD_SCRIPTS_DIR "${CMAKE_INSTALL_BINDIR}")
  install(DIRECTORY "${PROJECT_SOURCE_DIR}/python/bagnold" COMPONENT program
    DESTINATION "${CMAKE_INSTALL_DATADIR}/bagnold/python" PATTERN "__pycache__" EXCLUDE)
endif()
install(PROGRAMS "$<TARGET_FILE:bagnold>" DESTINATION "${SKBUILD_SCRIPTS_DIR}" COMPONENT program)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/inputs/" COMPONENT program
  DESTINATION "${CMAKE_INSTALL_DATADIR}/bagnold" PATTERN "checks" EXCLUDE)
include("${CMAKE_CURRENT_LIST_DIR}/shell.cmake")
