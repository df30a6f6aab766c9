# SPDX-License-Identifier: BSD-3-Clause
#
# cmake/kokkos.cmake with packages that say they are Kokkos: one whose programs crash is refused with the
# remedy, one whose programs run is taken; where programs run elsewhere nothing is tried.
cmake_minimum_required(VERSION 3.25)

# A package in WORK/NAME whose View does `action` when it is assigned.
function(make_kokkos name action)
  file(WRITE "${WORK}/${name}/KokkosConfig.cmake"
    "set(Kokkos_DEVICES SERIAL)\n"
    "add_library(Kokkos::kokkos INTERFACE IMPORTED)\n"
    "target_include_directories(Kokkos::kokkos INTERFACE \"\${CMAKE_CURRENT_LIST_DIR}\")\n")
  file(WRITE "${WORK}/${name}/KokkosConfigVersion.cmake"
    "set(PACKAGE_VERSION 4.6.99)\nset(PACKAGE_VERSION_COMPATIBLE TRUE)\n")
  file(WRITE "${WORK}/${name}/Kokkos_Core.hpp"
    "#include <cstdlib>\n"
    "namespace Kokkos {\n"
    "struct HostSpace {};\n"
    "template <class, class> struct View {\n"
    "  View() = default;\n"
    "  View(View const&) = default;\n"
    "  View& operator=(View const&) { ${action}; return *this; }\n"
    "  int extent(int) const { return 0; }\n"
    "};\n"
    "}\n")
endfunction()

include("${CMAKE_CURRENT_LIST_DIR}/configure_probe.cmake")

file(REMOVE_RECURSE "${WORK}")
file(WRITE "${WORK}/CMakeLists.txt" "cmake_minimum_required(VERSION 3.25)\nproject(probe CXX)\n"
  "include([[${SOURCE}/cmake/kokkos.cmake]])\n")
make_kokkos(sound "")
make_kokkos(broken "std::abort()")
configure_probe(TRUE "Kokkos 4.6.99 with SERIAL" "-DKokkos_DIR=${WORK}/sound")
configure_probe(FALSE "-DKokkos_ENABLE_IMPL_VIEW_LEGACY=ON" "-DKokkos_DIR=${WORK}/broken")
configure_probe(TRUE "not tried" "-DKokkos_DIR=${WORK}/broken" -DCMAKE_SYSTEM_NAME=Linux)
