# SPDX-License-Identifier: BSD-3-Clause
# configure_probe(SUCCEEDS WORDS ARGUMENT...): configuring the project in WORK says WORDS, and succeeds or not.
# Leaves what was said, on one line, in `said`.
function(configure_probe succeeds words)
  file(REMOVE_RECURSE "${WORK}/build")
  execute_process(COMMAND "${CMAKE_COMMAND}" -S "${WORK}" -B "${WORK}/build" -G "${GENERATOR}"
    "-DCMAKE_CXX_COMPILER=${COMPILER}" ${ARGN}
    OUTPUT_VARIABLE said ERROR_VARIABLE said RESULT_VARIABLE code)
  string(REGEX REPLACE "[ \n]+" " " said "${said}")
  string(FIND "${said}" "${words}" at)
  if((code EQUAL 0 AND NOT succeeds) OR (NOT code EQUAL 0 AND succeeds) OR at EQUAL -1)
    message(FATAL_ERROR "${ARGN}: code ${code}, wanted \"${words}\", said: ${said}")
  endif()
  set(said "${said}" PARENT_SCOPE)
endfunction()
