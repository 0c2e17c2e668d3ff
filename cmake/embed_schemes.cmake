# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DOUTPUT=FILE.cpp "-DFILES=a.toml;b.toml" -P embed_schemes.cmake
set(text "// SPDX-License-Identifier: GPL-3.0-or-later\n// Made from symbolic/schemes by cmake/embed_schemes.cmake.\n")
string(APPEND text "#include \"twoscale/symbolic/scheme_file.hpp\"\n\nnamespace twoscale {\n\n")
string(APPEND text "const std::vector<std::pair<std::string, std::string>>& embedded_scheme_files() {\n")
string(APPEND text "  static const std::vector<std::pair<std::string, std::string>> files = {\n")
foreach(file IN LISTS FILES)
  get_filename_component(name "${file}" NAME_WE)
  file(READ "${file}" content)
  string(APPEND text "      {\"${name}\", R\"toml(${content})toml\"},\n")
endforeach()
string(APPEND text "  };\n  return files;\n}\n\n}  // namespace twoscale\n")
file(WRITE "${OUTPUT}" "${text}")
