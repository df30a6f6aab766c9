# SPDX-License-Identifier: BSD-3-Clause
#
# `cpack -G DEB` in a build folder: bagnold_VERSION_ARCH.deb, the program with its scenes, completion and manual
# pages, and bagnold-dev_VERSION_ARCH.deb, headers and libraries for programs of one's own. `cpack -G TGZ`: the same
# as archives. A package for others is one of a build with -DBAGNOLD_NATIVE=OFF.

set(CPACK_PACKAGE_NAME bagnold)
set(CPACK_PACKAGE_VENDOR "The Bagnold authors")
set(CPACK_PACKAGE_CONTACT "The Bagnold authors <bagnold@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "dense granular flow of soft disks at vanishing shear rate")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_COMPONENTS_ALL program development)
set(CPACK_ARCHIVE_COMPONENT_INSTALL ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
string(CONCAT CPACK_COMPONENT_PROGRAM_DESCRIPTION
  "Simulates soft, frictionless, bidisperse disks in two dimensions under\n"
  "Lees-Edwards shear: Bagnold and Newtonian rheology, shear banding, jamming.")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "Headers and static libraries of Bagnold, for contact laws and drives of one's own.")

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME bagnold)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "python3, python3-h5py, python3-matplotlib")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "paraview, slurm-client")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME bagnold-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  "libeigen3-dev, libhdf5-dev, libtomlplusplus-dev, libfmt-dev, nlohmann-json3-dev, libxxhash-dev")
if(BAGNOLD_NATIVE)
  string(APPEND CPACK_COMPONENT_PROGRAM_DESCRIPTION
    "\nBuilt with all instructions of the processor that built it: for that kind of\nmachine only.")
endif()
include(CPack)
