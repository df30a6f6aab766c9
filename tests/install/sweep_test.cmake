# SPDX-License-Identifier: BSD-3-Clause
#
# Installs the build into WORK/prefix, builds a program that runs a sweep as a library call, away from the tree,
# and runs it with the installed program for the points.
cmake_minimum_required(VERSION 3.25)

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE "${WORK}")
run("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${WORK}/prefix")
file(COPY "${CONSUMER}" DESTINATION "${WORK}")
run("${CMAKE_COMMAND}" -S "${WORK}/sweep_consumer" -B "${WORK}/build" -G "${GENERATOR}"
  "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}"
  "-DCMAKE_PREFIX_PATH=${WORK}/prefix" -DCMAKE_CXX_FLAGS_RELEASE=-O1)  # compile quickly
run("${CMAKE_COMMAND}" --build "${WORK}/build")
run("${WORK}/build/sweep_consumer" "${WORK}/sweep_consumer/sweep.toml" "${WORK}/runs" "${WORK}/prefix/bin/bagnold")
