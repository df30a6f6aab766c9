# SPDX-License-Identifier: BSD-3-Clause
#
# cmake -DPROGRAM=FILE -DHELP2MAN=FILE -DOUTPUT=DIR -P: bagnold.1.gz and a page for each command that PROGRAM
# lists, bagnold-run.1.gz and so on, from what it says of itself.
cmake_minimum_required(VERSION 3.25)

file(REMOVE_RECURSE "${OUTPUT}")
file(MAKE_DIRECTORY "${OUTPUT}/called")
function(say_of output)
  execute_process(COMMAND "${PROGRAM}" ${ARGN} OUTPUT_VARIABLE said COMMAND_ERROR_IS_FATAL ANY)
  set(${output} "${said}" PARENT_SCOPE)
endfunction()

# page(NAME WHAT WORD...): NAME.1 of `PROGRAM WORD...`, which help2man calls by that name.
function(page name what)
  list(JOIN ARGN " " words)
  file(WRITE "${OUTPUT}/called/${name}" "#!/bin/sh\nexec '${PROGRAM}' ${words} \"$@\"\n")
  file(CHMOD "${OUTPUT}/called/${name}" PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)
  execute_process(COMMAND "${HELP2MAN}" --no-info --section=1 "--name=${what}" "--version-string=${version}"
    "--manual=Bagnold" "--source=Bagnold ${version}" "--output=${OUTPUT}/${name}.1" "${OUTPUT}/called/${name}"
    COMMAND_ERROR_IS_FATAL ANY)
  file(ARCHIVE_CREATE OUTPUT "${OUTPUT}/${name}.1.gz" PATHS "${OUTPUT}/${name}.1" FORMAT raw COMPRESSION GZip
    COMPRESSION_LEVEL 9)
endfunction()

say_of(version --version)
string(REGEX MATCH "[0-9]+([.][0-9]+)+" version "${version}")
say_of(help --help)
page(bagnold "dense granular flow of soft disks at vanishing shear rate")
string(REPLACE ";" "," help "${help}")
string(REGEX REPLACE ".*\nSubcommands:\n" "" commands "${help}")
string(REGEX REPLACE "\n\n.*" "" commands "${commands}")
string(REGEX MATCHALL "(^|\n)  [a-z][a-z-]+ +[^\n]+" commands "${commands}")
foreach(line IN LISTS commands)
  string(REGEX MATCH "^\n?  ([a-z-]+) +(.+)$" line "${line}")
  page(bagnold-${CMAKE_MATCH_1} "${CMAKE_MATCH_2}" ${CMAKE_MATCH_1})
endforeach()
file(REMOVE_RECURSE "${OUTPUT}/called")
