# SPDX-License-Identifier: BSD-3-Clause
#
# bagnold_host_only(TARGET [SOURCE...]): nvcc reads every source for the device too, which has no vector types and
# needs none: there a target's sources are empty but for Kokkos, except the ones named, which have kernels for a device.
function(bagnold_host_only target)
  if(CMAKE_CXX_COMPILER MATCHES "nvcc_wrapper$")
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON
      UNITY_BUILD_CODE_BEFORE_INCLUDE "#include <Kokkos_Core.hpp>\n#ifndef __CUDA_ARCH__"
      UNITY_BUILD_CODE_AFTER_INCLUDE "#endif")
    target_compile_options(${target} PRIVATE -Wno-subobject-linkage)  # as of bagnold_join
    set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  endif()
endfunction()
