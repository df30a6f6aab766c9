# SPDX-License-Identifier: BSD-3-Clause
#
# Configures and installs SOURCE without the program, where no library but Kokkos can be found, then
# builds and runs the consumer with it.
cmake_minimum_required(VERSION 3.25)

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

set(others "")
foreach(name IN ITEMS CLI11 Eigen3 GTest HDF5 benchmark fmt nlohmann_json tomlplusplus)
  list(APPEND others "-DCMAKE_DISABLE_FIND_PACKAGE_${name}=ON")
endforeach()

file(REMOVE_RECURSE "${WORK}")
run("${CMAKE_COMMAND}" -S "${SOURCE}" -B "${WORK}/kernels" -G "${GENERATOR}"
  "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DKokkos_DIR=${KOKKOS}" -DBAGNOLD_PROGRAM=OFF ${others})
run("${CMAKE_COMMAND}" --build "${WORK}/kernels")
run("${CMAKE_COMMAND}" --install "${WORK}/kernels" --prefix "${WORK}/prefix")
if(EXISTS "${WORK}/prefix/bin")
  message(FATAL_ERROR "the program was installed")
endif()
run("${CMAKE_COMMAND}" -S "${CONSUMER}" -B "${WORK}/consumer" -G "${GENERATOR}"
  "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_PREFIX_PATH=${WORK}/prefix")
run("${CMAKE_COMMAND}" --build "${WORK}/consumer")
run("${WORK}/consumer/consumer")
