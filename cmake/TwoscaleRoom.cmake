# SPDX-License-Identifier: GPL-3.0-or-later
# One library a room. A room is a directory with include/ (its only public include root) and src/.

set_property(GLOBAL PROPERTY TWOSCALE_ROOMS "")

# twoscale_room(NAME DIRECTORY [PUBLIC lib…] [PRIVATE lib…] [PCH header…])
#
# Makes the target twoscale_NAME (alias twoscale::NAME) from DIRECTORY/src/**.cpp. New files are picked up at the next
# build. A room without sources becomes an interface library, so that its headers can be used and checked.
function(twoscale_room name directory)
  cmake_parse_arguments(PARSE_ARGV 2 ARG "" "" "PUBLIC;PRIVATE;PCH")
  set(target twoscale_${name})
  set(root "${PROJECT_SOURCE_DIR}/${directory}")
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${root}/src/*.cpp")
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS "${root}/include/*.hpp")
  if(sources)
    add_library(${target} STATIC ${sources} ${headers})
    target_include_directories(${target} PUBLIC
      "$<BUILD_INTERFACE:${root}/include>" "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>"
      PRIVATE "${root}/src")
    target_link_libraries(${target} PUBLIC ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE})
    twoscale_own_target(${target})
    if(TWOSCALE_PCH AND ARG_PCH)
      target_precompile_headers(${target} PRIVATE ${ARG_PCH})
    endif()
  else()
    add_library(${target} INTERFACE)
    target_include_directories(${target} INTERFACE
      "$<BUILD_INTERFACE:${root}/include>" "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>")
    target_link_libraries(${target} INTERFACE ${ARG_PUBLIC})
    target_compile_features(${target} INTERFACE cxx_std_20)
  endif()
  add_library(twoscale::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES
    EXPORT_NAME ${name}
    TWOSCALE_ROOM_ROOT "${root}"
    TWOSCALE_ROOM_HEADERS "${headers}")
  set_property(GLOBAL APPEND PROPERTY TWOSCALE_ROOMS ${name})
endfunction()

# twoscale_room_compile_options(NAME option…): private options of a room; nothing when it has no sources.
function(twoscale_room_compile_options name)
  get_target_property(type twoscale_${name} TYPE)
  if(NOT type STREQUAL "INTERFACE_LIBRARY")
    target_compile_options(twoscale_${name} PRIVATE ${ARGN})
  endif()
endfunction()
