# SPDX-License-Identifier: BSD-3-Clause
#
# Installs the build into WORK/prefix, then configures, builds and runs the consumer with it.
cmake_minimum_required(VERSION 3.25)

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE "${WORK}")
run("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${WORK}/prefix")
run("${WORK}/prefix/bin/bagnold" --help)
if(PYTHON)  # pictures by the installed package
  file(WRITE "${WORK}/scene.toml" "[disks]\nmodel = \"CD\"\ncount = 16\npacking_fraction = 0.6\nelasticity = 1.0\n"
    "mass = \"equal\"\n[shear]\nstrain_rate = 1e-2\nstrain = 1.0\n")
  run("${WORK}/prefix/bin/bagnold" run "${WORK}/scene.toml" --out "${WORK}/run" --quiet)
  if(NOT EXISTS "${WORK}/run/plot.png")
    message(FATAL_ERROR "the installed program drew no picture")
  endif()
  file(GLOB_RECURSE compiled "${WORK}/prefix/*.pyc")
  if(compiled)
    message(FATAL_ERROR "written into the prefix: ${compiled}")
  endif()
endif()
run("${CMAKE_COMMAND}" -S "${CONSUMER}" -B "${WORK}/build" -G "${GENERATOR}"
  "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_PREFIX_PATH=${WORK}/prefix")
run("${CMAKE_COMMAND}" --build "${WORK}/build")
run("${WORK}/build/consumer")
