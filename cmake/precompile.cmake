# SPDX-License-Identifier: BSD-3-Clause
#
# bagnold_precompile(TARGET HEADER...): headers that most sources of a target include are read once.
# No source may need it: structure.headers compiles each header alone, without. Off where a compiler is
# launched by another program: ccache asks for settings of its own to go with it. Off for nvcc.

if(CMAKE_CXX_COMPILER_LAUNCHER OR CMAKE_CXX_COMPILER MATCHES "nvcc_wrapper$")
  set(bagnold_precompiles OFF)
else()
  set(bagnold_precompiles ON)
endif()
option(BAGNOLD_PRECOMPILE "Precompile headers of libraries" ${bagnold_precompiles})

set(bagnold_standard_headers <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <map> <memory>
  <optional> <string> <string_view> <tuple> <utility> <vector>)

function(bagnold_precompile target)
  if(BAGNOLD_PRECOMPILE)
    target_precompile_headers(${target} PRIVATE ${bagnold_standard_headers} ${ARGN})
  endif()
endfunction()
