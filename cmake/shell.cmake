# SPDX-License-Identifier: BSD-3-Clause
#
# What a shell knows of the installed program: completion of words, and manual pages, which help2man makes at
# installation of what the program says of itself. Without help2man there are none, and the installation says so.

install(FILES "${PROJECT_SOURCE_DIR}/packaging/completion/bagnold.bash" RENAME bagnold COMPONENT program
  DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions")
# Debian's zsh looks for those of packages in a folder of their own.
install(CODE "set(folder site-functions)
  if(CMAKE_INSTALL_PREFIX MATCHES \"/usr$\" AND EXISTS /etc/debian_version)
    set(folder vendor-completions)
  endif()
  file(INSTALL DESTINATION \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_DATADIR}/zsh/\${folder}\"
    TYPE FILE FILES \"${PROJECT_SOURCE_DIR}/packaging/completion/_bagnold\")" COMPONENT program)

find_program(BAGNOLD_HELP2MAN help2man)
mark_as_advanced(BAGNOLD_HELP2MAN)
set(bagnold_pages "${PROJECT_BINARY_DIR}/man")
if(CMAKE_CROSSCOMPILING)
  install(CODE "message(STATUS \"No manual pages: the program runs on another machine\")" COMPONENT program)
elseif(NOT BAGNOLD_HELP2MAN)
  install(CODE "message(STATUS \"No manual pages: help2man was not found\")" COMPONENT program)
else()
  install(CODE "execute_process(COMMAND \"${CMAKE_COMMAND}\" \"-DPROGRAM=$<TARGET_FILE:bagnold>\"
    \"-DHELP2MAN=${BAGNOLD_HELP2MAN}\" \"-DOUTPUT=${bagnold_pages}\"
    -P \"${PROJECT_SOURCE_DIR}/cmake/man_pages.cmake\" RESULT_VARIABLE code)
  if(code)
    message(WARNING \"No manual pages: help2man could not make them (see above)\")
  endif()" COMPONENT program)
  install(DIRECTORY "${bagnold_pages}/" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1" COMPONENT program
    FILES_MATCHING PATTERN "*.1.gz")
endif()
