# SPDX-License-Identifier: BSD-3-Clause
#
# Installs the build into WORK/prefix, builds the example with it, away from the tree, and has it looked at.
cmake_minimum_required(VERSION 3.25)

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE "${WORK}")
run("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${WORK}/prefix")
file(COPY "${EXAMPLE}" DESTINATION "${WORK}")
run("${CMAKE_COMMAND}" -S "${WORK}/own_law" -B "${WORK}/build" -G "${GENERATOR}"
  "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}"
  "-DCMAKE_PREFIX_PATH=${WORK}/prefix" -DCMAKE_CXX_FLAGS_RELEASE=-O1)  # compile quickly
run("${CMAKE_COMMAND}" --build "${WORK}/build")
run("${PYTHON}" "${TEST}" "${WORK}/build/own_law" "${WORK}/prefix/bin/bagnold" "${WORK}/own_law/scene.toml"
  "${WORK}/runs")
