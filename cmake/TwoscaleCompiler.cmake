# SPDX-License-Identifier: GPL-3.0-or-later
# Compiler settings of the project's own targets: warnings, ccache.

set(TWOSCALE_WARNING_FLAGS -Wall -Wextra -Wpedantic -Wshadow -Wconversion)

if(TWOSCALE_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  find_program(TWOSCALE_CCACHE_PROGRAM ccache)
  mark_as_advanced(TWOSCALE_CCACHE_PROGRAM)
  if(TWOSCALE_CCACHE_PROGRAM)
    # Precompiled headers are cached only with this sloppiness and with -fpch-preprocess below.
    set(CMAKE_CXX_COMPILER_LAUNCHER
      "${CMAKE_COMMAND}" -E env "CCACHE_SLOPPINESS=pch_defines,time_macros" "${TWOSCALE_CCACHE_PROGRAM}")
  endif()
endif()

# twoscale_own_target(TARGET): what every compiled target of this project gets.
function(twoscale_own_target target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_compile_definitions(${target} PRIVATE TWOSCALE_VERSION="${PROJECT_VERSION}")
  if(TWOSCALE_WARNINGS)
    target_compile_options(${target} PRIVATE ${TWOSCALE_WARNING_FLAGS})
  endif()
  if(TWOSCALE_PCH AND TWOSCALE_CCACHE_PROGRAM AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${target} PRIVATE -fpch-preprocess)
  endif()
endfunction()
