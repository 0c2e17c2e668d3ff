// SPDX-License-Identifier: GPL-3.0-or-later
// Reading of scheme files: TOML to entries with positions. What the entries mean is scheme_builder.cpp's.
#include "twoscale/symbolic/scheme_file.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

#include "twoscale/symbolic/error.hpp"

namespace twoscale {

namespace {

using Type = SchemeFileKey::Type;
using Entry = SchemeFile::Entry;

constexpr std::size_t largest_file = 1 << 20;
constexpr std::size_t longest_quote = 80;  // characters of the text at fault in a message
constexpr std::size_t most_parameters = 32;
constexpr std::size_t most_claims = 256;
constexpr int largest_arity = 64;
constexpr int largest_block = 8;
constexpr long largest_offset = 2048;

// The edit distance of two words (insert, remove, change a letter).
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t change = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({change, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row[b.size()];
}

std::string list_of(const std::vector<std::string>& words) {
  std::string text;
  for (const auto& w : words) text += (text.empty() ? "" : ", ") + w;
  return text;
}

// ", did you mean arity?", or ", not one of a, b, c".
std::string suggestion(const std::string& word, const std::vector<std::string>& known) {
  const auto best = std::min_element(
      known.begin(), known.end(), [&](const auto& a, const auto& b) { return distance(word, a) < distance(word, b); });
  if (best != known.end() && word.size() < 64 &&
      distance(word, *best) <= std::max<std::size_t>(word.size() < 4 ? 1 : 2, best->size() / 3))
    return ", did you mean " + *best + "?";
  return ", it is none of " + list_of(known);
}

bool is_name(std::string_view s, bool dashes) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  return !s.empty() && s.size() <= 64 && letter(s[0]) && std::all_of(s.begin(), s.end(), [&](char c) {
    return letter(c) || (c >= '0' && c <= '9') || c == '_' || (dashes && c == '-');
  });
}

}  // namespace

const std::vector<SchemeFileKey>& scheme_file_keys() {
  static const std::vector<SchemeFileKey> keys = {
      {"scheme", "name", Type::name, true, "what outputs and certificates call the scheme"},
      {"scheme", "title", Type::text, false, "one line about the scheme"},
      {"scheme", "source", Type::text, false, "paper and place"},
      {"scheme", "arity", Type::integer, false, "the arity m, 2 to 64; 2 if absent"},
      {"scheme", "block", Type::integer, false, "the size of the blocks of a vector scheme, 1 to 8; 1 if absent"},
      {"scheme", "shift", Type::expression, false,
       "p: the point j of level k belongs to (j + p)/m^k; if absent, c/(m-1) for a mask symmetric about c"},
      {"scheme", "space", Type::text, false,
       "functions that the scheme is made for; the symbol may use the level variables of its frequencies"},
      {"scheme", "symbol", Type::expression, false,
       "a(z) = sum a_i z^i, in z and the parameters; also outside of any table; or phases"},
      {"parameters.NAME", "scope", Type::text, true,
       "constant: one value; level: a value for each level; local: a value for each edge"},
      {"parameters.NAME", "domain", Type::interval, false,
       "the values that are accepted, of level 0 for a level parameter"},
      {"parameters.NAME", "relation", Type::expression, false,
       "level: the coarse value as a polynomial in the fine one, which is called NAME"},
      {"parameters.NAME", "offsets", Type::integers, false,
       "local: the edges that a stencil reads; the value at edge i + 2 is called NAME_2, at i - 1 NAME_m1"},
      {"parameters.NAME", "default", Type::expression, false,
       "the value when none is given, of level 0 for a level parameter"},
      {"parameters.NAME", "help", Type::text, false, "one line about the parameter"},
      {"phase", "residue", Type::integer, true, "s: the stencil makes the points m*j + s"},
      {"phase", "stencil", Type::stencil, true,
       "{\"-1\" = \"1/8\", \"0\" = \"3/4\", ...}: the weights of the points j - 1, j, ...; arrays of arrays for "
       "blocks"},
      {"claim", "claim", Type::text, true,
       "interpolatory, symmetric, sum-rules, generates, reproduces, maximal, well-defined, continuity, contractive"},
      {"claim", "subject", Type::subject, false, "what it is about: a space, an order"},
      {"claim", "source", Type::text, false, "who claims it"}};
  return keys;
}

const char* type_text(Type type) {
  switch (type) {
    case Type::name: return "name (letters, digits, - and _, a letter first)";
    case Type::text: return "string";
    case Type::integer: return "integer";
    case Type::expression: return "expression (string or integer)";
    case Type::interval: return "interval (string)";
    case Type::integers: return "array of integers";
    case Type::stencil: return "table of expressions";
    case Type::subject: return "string or integer";
  }
  return "";
}

// Walks the TOML tree along the schema.
class SchemeFileReader {
 public:
  SchemeFileReader(std::string_view text, const std::string& path) : text_(text) { file_.path_ = path; }

  SchemeFile read() {
    if (text_.size() > largest_file)
      bad_input(file_.path_ + ": a scheme file of more than 1 MiB", std::to_string(text_.size()) + " bytes");
    toml::table root;
    try {
      root = toml::parse(text_, file_.path_);
    } catch (const toml::parse_error& e) {
      std::string what(e.description());
      std::replace(what.begin(), what.end(), '\n', ' ');
      fail(e.source().begin, what, line_text(e.source().begin.line));
    }
    for (auto&& [key, node] : root) {
      const std::string name(key.str());
      if (name == "scheme")
        read_scheme(table_at(node, "[scheme]"));
      else if (name == "parameters")
        read_parameters(table_at(node, "[parameters.NAME]"));
      else if (name == "phase")
        for_each_table(node, "[[phase]]", [this](const toml::table& t) { read_phase(t); });
      else if (name == "claim")
        for_each_table(node, "[[claim]]", [this](const toml::table& t) { read_claim(t); });
      else if (name != "symbol")
        fail(key.source().begin,
             "unknown table" + suggestion(name, {"scheme", "parameters", "phase", "claim", "symbol"}), name);
    }
    if (!root.contains("scheme")) bad_input(file_.path_ + ":1:1: the table [scheme] is missing");
    if (const toml::node* symbol = root.get("symbol")) {
      if (file_.symbol_.present()) fail(symbol->source().begin, "symbol is given twice, here and in [scheme]");
      file_.symbol_ = value(*symbol, "symbol", Type::expression);
    }
    check_blocks();
    return std::move(file_);
  }

 private:
  using Position = toml::source_position;

  [[noreturn]] void fail(const Position& at, const std::string& message, std::string piece = {}) const {
    if (piece.size() > longest_quote) piece = piece.substr(0, longest_quote) + "...";
    bad_input(file_.path_ + ":" + std::to_string(at.line) + ":" + std::to_string(at.column) + ": " + message,
              std::move(piece));
  }
  [[noreturn]] void fail(const Entry& at, const std::string& message, std::string piece = {}) const {
    fail(Position{at.line, at.column}, message, std::move(piece));
  }

  // The line, printable: what stands where TOML gave up.
  std::string line_text(unsigned line) const {
    std::string_view rest = text_;
    for (unsigned i = 1; i < line; ++i) {
      const auto end = rest.find('\n');
      if (end == std::string_view::npos) return "";
      rest.remove_prefix(end + 1);
    }
    std::string s(rest.substr(0, std::min(rest.find('\n'), longest_quote)));
    for (char& c : s)
      if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7e) c = '?';
    return s;
  }

  const toml::table& table_at(const toml::node& node, const std::string& what) const {
    if (const auto* t = node.as_table()) return *t;
    fail(node.source().begin, what + " is a table");
  }

  template <typename F>
  void for_each_table(const toml::node& node, const std::string& what, F f) const {
    const auto* list = node.as_array();
    if (list == nullptr) fail(node.source().begin, what + " is an array of tables, in double brackets");
    for (const toml::node& item : *list) f(table_at(item, what));
  }

  // Keys that the schema does not have, and required ones that are not there.
  void check_keys(const toml::table& t, const std::string& schema, const std::string& shown) const {
    std::vector<std::string> known;
    for (const auto& k : scheme_file_keys())
      if (schema == k.table) known.emplace_back(k.key);
    for (auto&& [key, node] : t) {
      const std::string name(key.str());
      if (std::find(known.begin(), known.end(), name) == known.end())
        fail(key.source().begin, "unknown key of " + shown + suggestion(name, known), name);
    }
    for (const auto& k : scheme_file_keys())
      if (schema == k.table && k.required && !t.contains(k.key))
        fail(t.source().begin, shown + " needs the key", k.key);
  }

  Entry entry(const toml::node& node, std::string text) const {
    const auto& s = node.source();
    return {std::move(text), s.begin.line, s.begin.column, s.begin.line == s.end.line};
  }

  Entry value(const toml::node& node, const std::string& key, Type type) const {
    if (const auto* s = node.as_string()) {
      const Entry e = entry(node, s->get());
      if (type == Type::integer) fail(e, key + " is an integer, without quotes", e.text);
      if (type == Type::name && !is_name(e.text, true))
        fail(e, key + " is a name: letters, digits, - and _, a letter first", e.text);
      for (const char c : e.text)
        if (static_cast<unsigned char>(c) < 0x20) fail(e, key + " contains a control character");
      return e;
    }
    if (const auto* i = node.as_integer()) {
      const Entry e = entry(node, std::to_string(i->get()));
      if (type == Type::integer || type == Type::expression || type == Type::subject) return e;
      fail(e, key + " is a " + type_text(type) + ", in quotes", e.text);
    }
    if (node.is_floating_point() && type != Type::text)
      fail(node.source().begin, key + " is a floating-point number, which is not exact: write it in quotes");
    fail(node.source().begin, key + " is a " + std::string(type_text(type)));
  }

  Entry value_in(const toml::table& t, const char* key, Type type) const {
    const toml::node* node = t.get(key);
    return node == nullptr ? Entry{} : value(*node, key, type);
  }

  // Of a table of the schema: every key of a scalar type has one type there.
  Entry scalar(const toml::table& t, const std::string& schema, const char* key) const {
    for (const auto& k : scheme_file_keys())
      if (schema == k.table && std::strcmp(key, k.key) == 0) return value_in(t, key, k.type);
    throw std::logic_error("scheme file schema: " + schema + "." + key);
  }

  long integer_of(const Entry& e, const std::string& key, long least, long greatest) const {
    const long n = std::stol(e.text);
    if (n < least || n > greatest)
      fail(e, key + " must lie between " + std::to_string(least) + " and " + std::to_string(greatest), e.text);
    return n;
  }

  void read_scheme(const toml::table& t) {
    check_keys(t, "scheme", "[scheme]");
    file_.name_ = scalar(t, "scheme", "name");
    file_.title_ = scalar(t, "scheme", "title");
    file_.source_ = scalar(t, "scheme", "source");
    file_.arity_ = scalar(t, "scheme", "arity");
    file_.block_ = scalar(t, "scheme", "block");
    file_.shift_ = scalar(t, "scheme", "shift");
    file_.space_ = scalar(t, "scheme", "space");
    file_.symbol_ = scalar(t, "scheme", "symbol");
    if (file_.arity_.present()) integer_of(file_.arity_, "arity", 2, largest_arity);
    if (file_.block_.present()) integer_of(file_.block_, "block", 1, largest_block);
  }

  void read_parameters(const toml::table& t) {
    if (t.size() > most_parameters) fail(t.source().begin, "more than 32 parameters");
    for (auto&& [key, node] : t) {
      SchemeFile::ParameterEntry p;
      p.name = {std::string(key.str()), key.source().begin.line, key.source().begin.column, true};
      const std::string shown = "[parameters." + p.name.text + "]";
      if (!is_name(p.name.text, false))
        fail(p.name, "the name of a parameter has letters, digits and _, a letter first", p.name.text);
      const toml::table& table = table_at(node, shown);
      check_keys(table, "parameters.NAME", shown);
      p.scope = scalar(table, "parameters.NAME", "scope");
      p.domain = scalar(table, "parameters.NAME", "domain");
      p.relation = scalar(table, "parameters.NAME", "relation");
      p.default_value = scalar(table, "parameters.NAME", "default");
      p.help = scalar(table, "parameters.NAME", "help");
      if (const toml::node* offsets = table.get("offsets")) read_offsets(*offsets, p);
      const std::string& scope = p.scope.text;
      if (scope != "constant" && scope != "level" && scope != "local")
        fail(p.scope, "unknown scope" + suggestion(scope, {"constant", "level", "local"}), scope);
      if (p.relation.present() && scope != "level") fail(p.relation, "a relation belongs to the scope level", scope);
      if (p.offsets_at.present() && scope != "local") fail(p.offsets_at, "offsets belong to the scope local", scope);
      if (scope == "local" && !p.offsets_at.present()) fail(p.scope, shown + " needs the key", "offsets");
      if (scope == "local" && p.default_value.present())
        fail(p.default_value, "values of local parameters come with the data, they have no default");
      file_.parameters_.push_back(std::move(p));
    }
  }

  void read_offsets(const toml::node& node, SchemeFile::ParameterEntry& p) const {
    p.offsets_at = entry(node, "");
    const auto* list = node.as_array();
    if (list == nullptr || list->empty()) fail(node.source().begin, "offsets is a non-empty array of integers");
    for (const toml::node& item : *list) {
      const Entry e = value(item, "offsets", Type::integer);
      const long h = integer_of(e, "an offset", -largest_offset, largest_offset);
      if (std::find(p.offsets.begin(), p.offsets.end(), h) != p.offsets.end()) fail(e, "offset is given twice", e.text);
      p.offsets.push_back(h);
    }
    std::sort(p.offsets.begin(), p.offsets.end());
  }

  void read_phase(const toml::table& t) {
    check_keys(t, "phase", "[[phase]]");
    SchemeFile::PhaseEntry p;
    p.residue = scalar(t, "phase", "residue");
    integer_of(p.residue, "residue", 0, largest_arity - 1);
    for (const auto& other : file_.phases_)
      if (other.residue.text == p.residue.text) fail(p.residue, "residue is given twice", p.residue.text);
    const toml::node& stencil = *t.get("stencil");
    const toml::table& weights = table_at(stencil, "stencil");
    if (weights.empty()) fail(stencil.source().begin, "the stencil is empty");
    for (auto&& [key, node] : weights) {
      const std::string name(key.str());
      const std::string digits = name.substr(name.starts_with('-') ? 1 : 0);
      const bool offset = !digits.empty() && digits.size() < 8 && (digits == name || digits != "0") &&
                          std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; }) &&
                          (digits.size() == 1 || digits[0] != '0');
      if (!offset || std::abs(std::stol(name)) > largest_offset)
        fail(key.source().begin, "the keys of a stencil are offsets, integers from -2048 to 2048 in quotes", name);
      std::vector<Entry> block;
      if (const auto* rows = node.as_array()) {
        for (const toml::node& row : *rows) {
          const auto* columns = row.as_array();
          if (columns == nullptr || columns->size() != rows->size())
            fail(row.source().begin, "a block is a square array of arrays", "offset " + name);
          for (const toml::node& x : *columns) block.push_back(value(x, "a weight", Type::expression));
        }
        if (block.empty()) fail(node.source().begin, "the block is empty", "offset " + name);
      } else {
        block.push_back(value(node, "a weight", Type::expression));
      }
      p.stencil.emplace(std::stol(name), std::move(block));
    }
    file_.phases_.push_back(std::move(p));
  }

  void read_claim(const toml::table& t) {
    check_keys(t, "claim", "[[claim]]");
    if (file_.claims_.size() == most_claims) fail(t.source().begin, "more than 256 claims");
    SchemeFile::ClaimEntry c{scalar(t, "claim", "claim"), scalar(t, "claim", "subject"), scalar(t, "claim", "source")};
    static const std::vector<std::string> known = {"interpolatory", "symmetric",   "sum-rules",  "generates",
                                                   "reproduces",    "maximal",     "continuity", "contractive",
                                                   "spectrum",      "well-defined"};
    if (std::find(known.begin(), known.end(), c.claim.text) == known.end())
      fail(c.claim, "unknown claim" + suggestion(c.claim.text, known), c.claim.text);
    file_.claims_.push_back(std::move(c));
  }

  // What needs arity and block to be known.
  void check_blocks() const {
    if (file_.symbol_.present() == !file_.phases_.empty())
      fail(file_.symbol_.present() ? file_.symbol_ : file_.name_,
           file_.symbol_.present() ? "a scheme has a symbol or phases, not both"
                                   : "a scheme needs a symbol or one [[phase]] for each residue");
    const long arity = file_.arity_.present() ? std::stol(file_.arity_.text) : 2;
    const std::size_t block = file_.block_.present() ? std::stoul(file_.block_.text) : 1;
    if (file_.symbol_.present()) {
      if (block > 1) fail(file_.symbol_, "a scheme with blocks is given by phases, not by a symbol");
      return;
    }
    for (const auto& p : file_.phases_) {
      if (std::stol(p.residue.text) >= arity)
        fail(p.residue, "residue must be less than the arity " + std::to_string(arity), p.residue.text);
      for (const auto& [offset, entries] : p.stencil)
        if (entries.size() != block * block)
          fail(entries[0], "the weight of offset " + std::to_string(offset) + " must be " +
                               (block == 1 ? "one expression"
                                           : "an array of " + std::to_string(block) + " arrays of " +
                                                 std::to_string(block) + " expressions"));
    }
    for (long s = 0; s < arity; ++s)
      if (std::none_of(file_.phases_.begin(), file_.phases_.end(),
                       [&](const auto& p) { return std::stol(p.residue.text) == s; }))
        fail(file_.phases_.back().residue, "a phase is missing, arity " + std::to_string(arity) + " needs the residue",
             std::to_string(s));
  }

  std::string_view text_;
  SchemeFile file_;
};

SchemeFile SchemeFile::parse(std::string_view text, const std::string& path) {
  return SchemeFileReader(text, path).read();
}

SchemeFile SchemeFile::load(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    throw Error(Error::Kind::io, "a scheme file is needed, not a directory", path);
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> in(std::fopen(path.c_str(), "rb"), std::fclose);
  if (!in) throw Error(Error::Kind::io, "scheme file cannot be read (" + std::string(std::strerror(errno)) + ")", path);
  std::string text(largest_file + 1, '\0');
  const std::size_t size = std::fread(text.data(), 1, text.size(), in.get());
  if (std::ferror(in.get()) != 0) throw Error(Error::Kind::io, "scheme file cannot be read", path);
  if (size > largest_file) bad_input("a scheme file of more than 1 MiB", path);
  text.resize(size);
  return parse(text, path);
}

std::string scheme_file_template(const std::string& name) {
  if (!is_name(name, true))
    bad_input("a scheme is called by letters, digits, - and _, a letter first, at most 64 of them", name);
  struct Line {
    const char* table;
    const char* key;
    std::string value;  // what the file has; starting with '#', an example that is commented out
  };
  const std::vector<Line> lines = {
      {"scheme", "name", "\"" + name + "\""},
      {"scheme", "title", "\"ternary three-point interpolating scheme with a parameter\""},
      {"scheme", "source", "\"Hassan and Dodgson 2003\""},
      {"scheme", "arity", "3"},
      {"scheme", "block", "#1"},
      {"scheme", "shift", "#0"},
      {"scheme", "space", "#\"1, x, exp(t*x), exp(-t*x)\""},
      {"scheme", "symbol", "#\"(1 + z + z^2)^2*(3*b*z^4 - 6*b*z^3 + (1 + 6*b)*z^2 - 6*b*z + 3*b)/(3*z^4)\""},
      {"parameters.b", "scope", "\"constant\""},
      {"parameters.b", "domain", "\"(-1/9, 0)\""},
      {"parameters.b", "relation", "#\"2*b^2 - 1\""},
      {"parameters.b", "offsets", "#[-1, 0, 1]"},
      {"parameters.b", "default", "\"-1/18\""},
      {"parameters.b", "help", "\"weight of the farther point; C^1 in this domain\""},
      {"phase", "residue", "0"},
      {"phase", "stencil", "{\"0\" = 1}"},
      {"phase", "residue", "1"},
      {"phase", "stencil", "{\"-1\" = \"b\", \"0\" = \"2/3 - 2*b\", \"1\" = \"1/3 + b\"}"},
      {"phase", "residue", "2"},
      {"phase", "stencil", "{\"0\" = \"1/3 + b\", \"1\" = \"2/3 - 2*b\", \"2\" = \"b\"}"},
      {"claim", "claim", "\"interpolatory\""},
      {"claim", "subject", ""},
      {"claim", "source", ""},
      {"claim", "claim", "\"symmetric\""},
      {"claim", "claim", "\"reproduces\""},
      {"claim", "subject", "\"1, x\""},
      {"claim", "source", "\"Hassan and Dodgson 2003\""},
      {"claim", "claim", "\"maximal\""},
      {"claim", "subject", "\"1, x\""}};
  std::string text =
      "# A scheme file of twoscale: a subdivision scheme\n#\n#     f^{k+1}_i = sum_j a^{[k]}_{i-m*j} f^k_j\n#\n"
      "# Expressions have + - * / ^ ( ), integers, fractions and decimals, all exact, and names of parameters.\n"
      "# Lines that begin with # are comments: examples of what is not used here.\n";
  std::string table;
  std::vector<std::string> explained;
  for (const Line& l : lines) {
    const std::string schema = std::string(l.table).starts_with("parameters.") ? "parameters.NAME" : l.table;
    const bool array = schema == "phase" || schema == "claim";
    const bool first_key = schema == "phase" ? std::strcmp(l.key, "residue") == 0 : std::strcmp(l.key, "claim") == 0;
    if (table != l.table || (array && first_key)) {
      text += std::string("\n") + (array ? "[[" : "[") + l.table + (array ? "]]\n" : "]\n");
      table = l.table;
    }
    const std::string full = schema + "." + l.key;
    if (std::find(explained.begin(), explained.end(), full) == explained.end()) {
      explained.push_back(full);
      for (const auto& k : scheme_file_keys())
        if (schema == k.table && std::strcmp(k.key, l.key) == 0)
          text += std::string("# ") + l.key + ": " + type_text(k.type) + (k.required ? ", required. " : ". ") + k.help +
                  "\n";
    }
    if (l.value.starts_with('#'))
      text += std::string("#") + l.key + " = " + l.value.substr(1) + "\n";
    else if (!l.value.empty())
      text += std::string(l.key) + " = " + l.value + "\n";
  }
  return text;
}

}  // namespace twoscale
