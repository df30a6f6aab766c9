# SPDX-License-Identifier: BSD-3-Clause
#
# cmake/libraries.cmake where header-only libraries are not found: what to do is said; with
# BAGNOLD_FETCH_LIBRARIES a download (here a folder that stands for it) becomes the same targets, which compile.
# Where they are found nothing is downloaded.
cmake_minimum_required(VERSION 3.25)

set(names Eigen3 tomlplusplus CLI11 nlohmann_json)
set(targets Eigen3::Eigen tomlplusplus::tomlplusplus CLI11::CLI11 nlohmann_json::nlohmann_json)
set(headers Eigen/Core toml++/toml.h CLI/CLI.hpp nlohmann/json.hpp)

include("${CMAKE_CURRENT_LIST_DIR}/configure_probe.cmake")

file(REMOVE_RECURSE "${WORK}")
list(JOIN targets " " linked)
file(WRITE "${WORK}/CMakeLists.txt" "cmake_minimum_required(VERSION 3.25)\nproject(probe C CXX)\n"
  "include([[${SOURCE}/cmake/libraries.cmake]])\nadd_executable(probe probe.cpp)\n"
  "target_link_libraries(probe ${linked})\n"
  "target_include_directories(probe PRIVATE \${RANDOM123_INCLUDE_DIR})\n"
  "message(STATUS \"Random123 in \${RANDOM123_INCLUDE_DIR}.\")\n")
set(program "")
foreach(header IN LISTS headers ITEMS Random123/philox.h)
  string(APPEND program "#include <${header}>\n")
endforeach()
file(WRITE "${WORK}/probe.cpp" "${program}int main() { return total; }\n")

# What stands for the downloads: headers that only they have.
set(hidden "")
set(downloads "")
set(number 0)
file(WRITE "${WORK}/downloads/total.hpp" "#pragma once\ninline int total = 0;\n")
foreach(name header IN ZIP_LISTS names headers)
  math(EXPR number "${number} + 1")
  set(folder include/)
  if(name STREQUAL Eigen3)
    set(folder "")
  endif()
  file(WRITE "${WORK}/downloads/${name}/${folder}${header}"
    "#include \"${WORK}/downloads/total.hpp\"\nstatic int const one_${number} = total++;\n")
  string(TOUPPER "${name}" upper)
  list(APPEND hidden "-DCMAKE_DISABLE_FIND_PACKAGE_${name}=ON")
  list(APPEND downloads "-DFETCHCONTENT_SOURCE_DIR_${upper}=${WORK}/downloads/${name}")
endforeach()
file(WRITE "${WORK}/downloads/Random123/include/Random123/philox.h" "#include \"${WORK}/downloads/total.hpp\"\n")
list(APPEND hidden -DRANDOM123_INCLUDE_DIR=RANDOM123_INCLUDE_DIR-NOTFOUND "-DCMAKE_IGNORE_PATH=/usr/include")
list(APPEND downloads "-DFETCHCONTENT_SOURCE_DIR_RANDOM123=${WORK}/downloads/Random123")

configure_probe(FALSE "tomlplusplus was not found" -DCMAKE_DISABLE_FIND_PACKAGE_tomlplusplus=ON)
configure_probe(FALSE "libtomlplusplus-dev" -DCMAKE_DISABLE_FIND_PACKAGE_tomlplusplus=ON)
configure_probe(FALSE "-DBAGNOLD_FETCH_LIBRARIES=ON" -DCMAKE_DISABLE_FIND_PACKAGE_CLI11=ON)

configure_probe(TRUE "Random123 in" -DBAGNOLD_FETCH_LIBRARIES=ON -DFETCHCONTENT_FULLY_DISCONNECTED=ON)
if(said MATCHES "downloaded")
  message(FATAL_ERROR "what is installed was downloaded: ${said}")
endif()

configure_probe(TRUE "Random123 in ${WORK}/downloads/Random123/include." -DBAGNOLD_FETCH_LIBRARIES=ON ${downloads} ${hidden}
  "-DXXHASH_INCLUDE_DIR=${WORK}" "-DXXHASH_LIBRARY=${WORK}")
foreach(name IN LISTS names)
  if(NOT said MATCHES "${name}: downloaded")
    message(FATAL_ERROR "${name} was not downloaded: ${said}")
  endif()
endforeach()
execute_process(COMMAND "${CMAKE_COMMAND}" --build "${WORK}/build" COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${WORK}/build/probe" RESULT_VARIABLE total)
if(NOT total EQUAL 4)
  message(FATAL_ERROR "the program was compiled with ${total} of 4 downloads")
endif()
