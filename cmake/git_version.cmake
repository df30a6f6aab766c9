# SPDX-License-Identifier: BSD-3-Clause
#
# cmake -DSOURCE=DIR -DOUTPUT=FILE -DVERSION=X -P: a header with version and git hash, rewritten only
# when they change. The source distribution tells its hash in a file.
find_program(GIT git)
set(hash "unknown")
if(EXISTS "${SOURCE}/third_party/git_hash")
  file(STRINGS "${SOURCE}/third_party/git_hash" hash)
elseif(GIT)
  execute_process(COMMAND "${GIT}" -C "${SOURCE}" describe --always --dirty --abbrev=12 --exclude "*"
    OUTPUT_VARIABLE found OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
  if(NOT failed)
    set(hash "${found}")
  endif()
endif()
set(text "// Made by cmake/git_version.cmake.\n#pragma once\n#define BAGNOLD_VERSION \"${VERSION}\"\n#define BAGNOLD_GIT_HASH \"${hash}\"\n")
set(old "")
if(EXISTS "${OUTPUT}")
  file(READ "${OUTPUT}" old)
endif()
if(NOT text STREQUAL old)
  file(WRITE "${OUTPUT}" "${text}")
endif()
