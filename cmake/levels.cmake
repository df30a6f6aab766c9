# SPDX-License-Identifier: BSD-3-Clause
#
# The engine on blocks once more for each level (src/engine/levels), with its instructions, joined to
# one object that shows `make_block_engine` of its namespace and nothing else: a function of the
# standard library compiled here must not be the one that the rest of the program calls.
file(GLOB bagnold_level_sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/engine/blocks/*.cpp")
list(APPEND bagnold_level_sources engine/contacts/contact_detector.cpp engine/drives/drive_engines.cpp
  engine/levels/level_engine.cpp ${bagnold_stepper_sources})

function(bagnold_level name architecture)
  add_library(bagnold_${name} OBJECT ${bagnold_level_sources})
  target_link_libraries(bagnold_${name} PRIVATE bagnold_kernels bagnold_config bagnold_statistics fmt::fmt)
  bagnold_host_only(bagnold_${name} engine/drives/drive_engines.cpp)
  target_compile_options(bagnold_${name} PRIVATE -march=${architecture} -fno-gnu-unique)
  target_compile_definitions(bagnold_${name} PRIVATE BAGNOLD_LEVEL=${name}
    $<TARGET_PROPERTY:bagnold_engine,INTERFACE_COMPILE_DEFINITIONS>)
  bagnold_precompile(bagnold_${name} <fmt/format.h> <Kokkos_Core.hpp>)
  set(objects "$<FILTER:$<TARGET_OBJECTS:bagnold_${name}>,EXCLUDE,[.]gch$>")
  set(joined "${CMAKE_CURRENT_BINARY_DIR}/${name}_joined.o")
  set(object "${CMAKE_CURRENT_BINARY_DIR}/${name}.o")
  add_custom_command(OUTPUT "${object}" DEPENDS bagnold_${name} "${objects}"
    COMMAND "${CMAKE_LINKER}" -r --force-group-allocation -o "${joined}" "${objects}"
    COMMAND "${CMAKE_OBJCOPY}" --wildcard "--keep-global-symbol=_ZN7bagnold*${name}*make_block_engine*"
      "${joined}" "${object}"
    COMMAND_EXPAND_LISTS VERBATIM)
  set_source_files_properties("${object}" PROPERTIES EXTERNAL_OBJECT ON GENERATED ON)
  target_sources(bagnold_engine PRIVATE "${object}")
endfunction()

set(bagnold_avx2 x86-64-v3)
set(bagnold_avx512 x86-64-v4)
foreach(level IN LISTS BAGNOLD_LEVELS)
  if(NOT DEFINED bagnold_${level})
    message(FATAL_ERROR "BAGNOLD_LEVELS has ${level}: use avx2 and avx512")
  endif()
  bagnold_level(${level} ${bagnold_${level}})
  string(TOUPPER "${level}" upper)
  set_property(SOURCE engine/levels/levels.cpp APPEND PROPERTY COMPILE_DEFINITIONS BAGNOLD_LEVEL_${upper})
endforeach()
# Of this source alone: another choice of levels leaves all others as they are built.
set_property(SOURCE engine/levels/levels.cpp PROPERTY SKIP_PRECOMPILE_HEADERS ON)
