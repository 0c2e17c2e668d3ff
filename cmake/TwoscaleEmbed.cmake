# SPDX-License-Identifier: GPL-3.0-or-later
# Data files of the rooms: read into the library, so that it needs no files at run time.

# twoscale_embed_texts(TARGET PATTERN HEADER NAMESPACE FUNCTION): the files of a pattern become pairs of name (without
# the ending; of the folder, if the pattern leaves that open) and text,
#   const std::vector<std::pair<std::string, std::string>>& NAMESPACE::FUNCTION(), declared in HEADER.
function(twoscale_embed_texts target pattern header namespace function)
  file(GLOB files CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/${pattern}")
  string(FIND "${pattern}" "/*/" folders)
  if(folders GREATER -1)
    set(folders ON)
  else()
    set(folders OFF)
  endif()
  set(script "${PROJECT_SOURCE_DIR}/cmake/embed_texts.cmake")
  set(generated "${PROJECT_BINARY_DIR}/${function}.cpp")
  add_custom_command(OUTPUT "${generated}"
    COMMAND "${CMAKE_COMMAND}" "-DOUTPUT=${generated}" "-DHEADER=${header}" "-DNAMESPACE=${namespace}"
      "-DFUNCTION=${function}" "-DFILES=${files}" "-DFOLDERS=${folders}" -P "${script}"
    DEPENDS ${files} "${script}" VERBATIM)
  target_sources(${target} PRIVATE "${generated}")
endfunction()

# twoscale_embed_schemes(TARGET DIRECTORY): the scheme files of the catalogue, which are installed too.
function(twoscale_embed_schemes target directory)
  twoscale_embed_texts(${target} "${directory}/*.toml" twoscale/symbolic/scheme_file.hpp twoscale embedded_scheme_files)
  file(GLOB files CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/${directory}/*.toml")
  install(FILES ${files} DESTINATION "${CMAKE_INSTALL_DATADIR}/twoscale/schemes")
endfunction()
