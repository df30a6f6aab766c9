# SPDX-License-Identifier: BSD-3-Clause
#
# Refuses a Kokkos with which programs of this compiler crash: g++ 12.2 to 12.4 skip a constructor of
# the Views that Kokkos has had since 4.6 (its issue 7464), without a word.

# With nvcc the same compilers leave Views without a value in functors, which then write anywhere on the device
# (Kokkos 4.7.00, nvcc 13.0, g++ 12.2: the fill of a View of one struct).
function(bagnold_refuse_new_views)
  if(NOT "CUDA" IN_LIST Kokkos_DEVICES OR Kokkos_VERSION VERSION_LESS 4.6)
    return()
  endif()
  set(host "${CMAKE_CXX_COMPILER_VERSION}")  # nvcc_wrapper tells that of the compiler under it
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL GNU OR host VERSION_LESS 12.2 OR host VERSION_GREATER_EQUAL 12.5)
    return()
  endif()
  find_file(bagnold_kokkos_config KokkosCore_config.h PATHS ${Kokkos_INCLUDE_DIR} "${Kokkos_DIR}/../../../include"
    NO_DEFAULT_PATH NO_CACHE)
  if(bagnold_kokkos_config)
    file(STRINGS "${bagnold_kokkos_config}" legacy REGEX "^#define KOKKOS_ENABLE_IMPL_VIEW_LEGACY")
    if(NOT legacy)
      message(FATAL_ERROR "Kokkos ${Kokkos_VERSION} in ${Kokkos_DIR}: with nvcc over g++ ${host} its new Views are "
        "without a value in functors. Build it with -DKokkos_ENABLE_IMPL_VIEW_LEGACY=ON, or take g++ 13.")
    endif()
  endif()
endfunction()

function(bagnold_try_kokkos)
  if(CMAKE_CROSSCOMPILING)
    message(STATUS "Kokkos: whether its programs run is not tried, as they run on another machine")
    return()
  endif()
  set(tried "${Kokkos_DIR} ${Kokkos_VERSION} ${CMAKE_CXX_COMPILER} ${CMAKE_CXX_COMPILER_VERSION}")
  string(MD5 tried "${tried}")
  set(ran "bagnold_kokkos_runs_${tried}")
  try_run(${ran} ${ran}_compiled SOURCES "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/kokkos_runs.cpp"
    LINK_LIBRARIES Kokkos::kokkos CXX_STANDARD 20 CXX_STANDARD_REQUIRED ON)
  if("${${ran}}" STREQUAL FAILED_TO_RUN)
    set(kokkos "Kokkos ${Kokkos_VERSION} in ${Kokkos_DIR}")
    unset(${ran} CACHE)  # so that the next try looks again
    unset(Kokkos_DIR CACHE)
    message(FATAL_ERROR "${kokkos}: a program of a few lines (cmake/kokkos_runs.cpp) crashes with it and "
      "${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}. g++ 12.2 to 12.4 do so with the Views of "
      "Kokkos 4.6.99. Do one of these:\n"
      "  * build that Kokkos with -DKokkos_ENABLE_IMPL_VIEW_LEGACY=ON;\n"
      "  * take another Kokkos, up to 4.6.01 or from 4.7 on, with -DKokkos_ROOT=PREFIX;\n"
      "  * take another compiler, such as g++ 13.\n")
  elseif(NOT "${${ran}}" STREQUAL 0)
    message(STATUS "Kokkos: whether its programs run could not be tried")
  endif()
endfunction()
