# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DOUTPUT=FILE.cpp -DHEADER=h.hpp -DNAMESPACE=a::b -DFUNCTION=f "-DFILES=a.toml;b.js" -P embed_texts.cmake
set(text "// SPDX-License-Identifier: GPL-3.0-or-later\n// Made by cmake/embed_texts.cmake.\n")
string(APPEND text "#include \"${HEADER}\"\n\nnamespace ${NAMESPACE} {\n\n")
string(APPEND text "const std::vector<std::pair<std::string, std::string>>& ${FUNCTION}() {\n")
string(APPEND text "  static const std::vector<std::pair<std::string, std::string>> files = {\n")
foreach(file IN LISTS FILES)
  get_filename_component(name "${file}" NAME_WE)
  file(READ "${file}" content)
  string(APPEND text "      {\"${name}\", R\"text(${content})text\"},\n")
endforeach()
string(APPEND text "  };\n  return files;\n}\n\n}  // namespace ${NAMESPACE}\n")
file(WRITE "${OUTPUT}" "${text}")
