// SPDX-License-Identifier: GPL-3.0-or-later
// Scheme files: a subdivision scheme as a person writes it down, in TOML (contract §5; docs/scheme-files.md).
//
// One table, scheme_file_keys(), is the schema: the reader takes its keys, types and requirements from it, `twoscale
// new` writes its comments from it, and the documentation is tested against it. Every error is Error(bad_input) of the
// form FILE:LINE:COLUMN: what is wrong: the text at fault; a file that cannot be read is Error(io).
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "twoscale/symbolic/scheme.hpp"

namespace twoscale {

struct SchemeFileKey {
  enum class Type {
    name,        // letters, digits, - and _, a letter first
    text,        // a string
    integer,     // a TOML integer
    expression,  // a string, or an integer
    interval,    // a string such as "[0, 1/8]"
    integers,    // an array of integers
    stencil,     // a table: offset -> expression, or block x block array of expressions
    subject,     // a string, or an integer
  };
  const char* table;  // "scheme", "parameters.NAME", "phase", "claim"
  const char* key;
  Type type;
  bool required;
  const char* help;
};
const std::vector<SchemeFileKey>& scheme_file_keys();
// "expression (string or integer)".
const char* type_text(SchemeFileKey::Type type);

// The file as read: which keys there are, where they stand, of which type. Expressions are read by scheme().
class SchemeFile {
 public:
  // `path` is what errors call the file.
  static SchemeFile parse(std::string_view text, const std::string& path);
  // At most 1 MiB is read. Throws Error(io) for what is no readable file.
  static SchemeFile load(const std::string& path);

  // A value and where it begins (line and column from 1).
  struct Entry {
    std::string text;
    unsigned line = 0;
    unsigned column = 0;
    bool one_line = true;  // the value ends in the line where it begins
    bool present() const { return line > 0; }
  };
  struct ParameterEntry {
    Entry name, scope, domain, relation, default_value, help;
    std::vector<long> offsets;
    Entry offsets_at;
  };
  struct PhaseEntry {
    Entry residue;
    std::map<long, std::vector<Entry>> stencil;  // offset -> block*block expressions, row-major
  };
  struct ClaimEntry {
    Entry claim, subject, source;
  };

  const std::string& path() const { return path_; }
  const std::string& name() const { return name_.text; }
  const std::string& title() const { return title_.text; }
  const std::string& source() const { return source_.text; }
  const std::vector<ParameterEntry>& parameters() const { return parameters_; }

  // The scheme; its id is name(), whatever the file is called.
  Scheme scheme() const;

 private:
  friend class SchemeFileReader;
  friend class SchemeBuilder;
  std::string path_;
  Entry name_, title_, source_, arity_, block_, shift_, space_, symbol_;
  std::vector<ParameterEntry> parameters_;
  std::vector<PhaseEntry> phases_;
  std::vector<ClaimEntry> claims_;
};

// A commented file that describes a working scheme (a ternary three-point scheme with a parameter) called `name`.
// Throws Error(bad_input) if that is no name.
std::string scheme_file_template(const std::string& name);

// The scheme files that come with the catalogue, by name: symbolic/schemes/NAME.toml.
const std::vector<std::pair<std::string, std::string>>& embedded_scheme_files();

}  // namespace twoscale
