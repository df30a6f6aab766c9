# SPDX-License-Identifier: BSD-3-Clause
#
# Makes the Debian packages of the build, unpacks them into a scratch root, and runs the program that is there, with
# the quickstart's scene cut short.
cmake_minimum_required(VERSION 3.25)

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE "${WORK}")
file(MAKE_DIRECTORY "${WORK}")
run("${CPACK}" -G DEB --config "${BUILD}/CPackConfig.cmake" -B "${WORK}")
file(GLOB packages "${WORK}/*.deb")
list(LENGTH packages count)
if(NOT count EQUAL 2)
  message(FATAL_ERROR "not two packages: ${packages}")
endif()
foreach(package IN LISTS packages)
  run(dpkg-deb --info "${package}")
  run(dpkg-deb --extract "${package}" "${WORK}/root")
endforeach()

file(GLOB program "${WORK}/bagnold_*.deb")
execute_process(COMMAND dpkg-deb --field "${program}" Depends OUTPUT_VARIABLE depends COMMAND_ERROR_IS_FATAL ANY)
foreach(library IN ITEMS libc6 libstdc\\+\\+6 libhdf5 libxxhash)
  if(NOT depends MATCHES "${library}")
    message(FATAL_ERROR "${program} does not depend on ${library}: ${depends}")
  endif()
endforeach()

set(usr "${WORK}/root/usr")
foreach(path IN ITEMS share/bash-completion/completions/bagnold share/bagnold/figures/figures.toml
    share/bagnold/quickstart.toml share/doc/bagnold/copyright include/bagnold/src/run/run.hpp lib/cmake/Bagnold/BagnoldRunTargets.cmake)
  string(REPLACE "lib/cmake" "${LIBRARIES}/cmake" path "${path}")
  if(NOT EXISTS "${usr}/${path}")
    message(FATAL_ERROR "no ${path} in the packages")
  endif()
endforeach()

# A manual page of the program, and of each command that completion offers.
if(HELP2MAN)
  file(GLOB pages RELATIVE "${usr}/share/man/man1" "${usr}/share/man/man1/*")
  foreach(page IN ITEMS bagnold.1.gz bagnold-run.1.gz bagnold-check-limit.1.gz bagnold-info.1.gz)
    if(NOT page IN_LIST pages)
      message(FATAL_ERROR "no ${page} in the package: ${pages}")
    endif()
  endforeach()
  execute_process(COMMAND gzip -dc "${usr}/share/man/man1/bagnold-run.1.gz" OUTPUT_VARIABLE page COMMAND_ERROR_IS_FATAL ANY)
  foreach(words IN ITEMS ".TH BAGNOLD-RUN \"1\"" "- run a scene, or go on" ".B bagnold" "out")
    string(FIND "${page}" "${words}" at)
    if(at EQUAL -1)
      message(FATAL_ERROR "bagnold-run.1 lacks ${words}: ${page}")
    endif()
  endforeach()
endif()

run("${usr}/bin/bagnold" run "${usr}/share/bagnold/quickstart.toml" --set shear.strain=0.1 --set disks.count=64
  --set output.plot=false --out "${WORK}/run")
if(NOT EXISTS "${WORK}/run/summary.json")
  message(FATAL_ERROR "no summary.json")
endif()
run("${usr}/bin/bagnold" figure)  # finds the installed list
