# SPDX-License-Identifier: BSD-3-Clause
#
# What spares the compiler reading the same headers for each source.
# bagnold_precompile(TARGET HEADER...): headers that most sources of a target include are read once.
# bagnold_join(TARGET [COUNT]): so many sources, 8, are compiled as one; names of their own must differ among them.
# bagnold_join_some(TARGET SOURCE...): these alone, as one.
# No source may need either: structure.headers compiles headers alone, the nightly check all sources. Off where a
# compiler is launched by another program, as ccache, which does better with small sources. No precompiled headers
# for nvcc.

if(CMAKE_CXX_COMPILER_LAUNCHER)
  set(bagnold_quick OFF)
else()
  set(bagnold_quick ON)
endif()
option(BAGNOLD_QUICK_BUILD "Precompile headers of libraries, and compile small sources together" ${bagnold_quick})

set(bagnold_standard_headers <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <map> <memory>
  <optional> <string> <string_view> <tuple> <utility> <vector>)

function(bagnold_precompile target)
  if(BAGNOLD_QUICK_BUILD AND NOT CMAKE_CXX_COMPILER MATCHES "nvcc_wrapper$")
    target_precompile_headers(${target} PRIVATE ${bagnold_standard_headers} ${ARGN})
  endif()
endfunction()

function(bagnold_join_some target)
  if(BAGNOLD_QUICK_BUILD AND NOT CMAKE_CXX_COMPILER MATCHES "nvcc_wrapper$")
    bagnold_join(${target})
    set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
    set_source_files_properties(${ARGN} PROPERTIES UNITY_GROUP some)
  endif()
endfunction()

function(bagnold_join target)
  if(BAGNOLD_QUICK_BUILD)
    set(count 8)
    if(ARGC GREATER 1)
      set(count ${ARGV1})
    endif()
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${count})
    # GCC takes the sources joined for headers, and warns of what is right in a source.
    target_compile_options(${target} PRIVATE $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wno-subobject-linkage>)
  endif()
endfunction()
