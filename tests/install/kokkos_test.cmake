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
    "template <class, class> struct View { View& operator=(View const&) { ${action}; return *this; } };\n"
    "}\n")
endfunction()

# configure(NAME WORDS SUCCEEDS ARGUMENT...): configuring with a package says WORDS, and succeeds or not.
function(configure name words succeeds)
  file(REMOVE_RECURSE "${WORK}/build")
  execute_process(COMMAND "${CMAKE_COMMAND}" -S "${WORK}" -B "${WORK}/build" -G "${GENERATOR}"
    "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DKokkos_DIR=${WORK}/${name}" ${ARGN}
    OUTPUT_VARIABLE said ERROR_VARIABLE said RESULT_VARIABLE code)
  string(REGEX REPLACE "[ \n]+" " " said "${said}")
  string(FIND "${said}" "${words}" at)
  if((code EQUAL 0 AND NOT succeeds) OR (NOT code EQUAL 0 AND succeeds) OR at EQUAL -1)
    message(FATAL_ERROR "${name}: code ${code}, wanted \"${words}\", said: ${said}")
  endif()
endfunction()

file(REMOVE_RECURSE "${WORK}")
file(WRITE "${WORK}/CMakeLists.txt" "cmake_minimum_required(VERSION 3.25)\nproject(probe CXX)\n"
  "include([[${SOURCE}/cmake/kokkos.cmake]])\n")
make_kokkos(sound "")
make_kokkos(broken "std::abort()")
configure(sound "Kokkos 4.6.99 with SERIAL" TRUE)
configure(broken "-DKokkos_ENABLE_IMPL_VIEW_LEGACY=ON" FALSE)
configure(broken "not tried" TRUE -DCMAKE_SYSTEM_NAME=Linux)
