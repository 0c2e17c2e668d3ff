# SPDX-License-Identifier: GPL-3.0-or-later
# Scheme files of the catalogue: read into the library, so that it needs no files at run time, and installed.

# twoscale_embed_schemes(TARGET DIRECTORY): DIRECTORY/*.toml become embedded_scheme_files() of TARGET.
function(twoscale_embed_schemes target directory)
  file(GLOB files CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/${directory}/*.toml")
  set(generated "${PROJECT_BINARY_DIR}/embedded_schemes.cpp")
  add_custom_command(OUTPUT "${generated}"
    COMMAND "${CMAKE_COMMAND}" "-DOUTPUT=${generated}" "-DFILES=${files}"
      -P "${PROJECT_SOURCE_DIR}/cmake/embed_schemes.cmake"
    DEPENDS ${files} "${PROJECT_SOURCE_DIR}/cmake/embed_schemes.cmake" VERBATIM)
  target_sources(${target} PRIVATE "${generated}")
  install(FILES ${files} DESTINATION "${CMAKE_INSTALL_DATADIR}/twoscale/schemes")
endfunction()
