// SPDX-License-Identifier: GPL-3.0-or-later
// The recipes. To add a scheme: one entry in catalog(), with its keys, examples, source and claims; the contract suite
// (tests/catalog) then runs over it by construction.
#include "twoscale/symbolic/catalog.hpp"

#include <algorithm>
#include <cctype>

#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"
#include "twoscale/symbolic/interpolatory.hpp"
#include "twoscale/symbolic/symbol.hpp"

namespace twoscale {

namespace {

bool starts_with_key(const std::string& piece) {
  size_t i = 0;
  while (i < piece.size() && (std::isalnum(static_cast<unsigned char>(piece[i])) != 0 || piece[i] == '_')) ++i;
  return i > 0 && i < piece.size() && piece[i] == '=' && std::isalpha(static_cast<unsigned char>(piece[0])) != 0;
}

std::string unquoted(std::string s) {
  s = trimmed(s);
  if (s.size() >= 2 && s.front() == '"' && s.back() == '"') s = s.substr(1, s.size() - 2);
  return s;
}

// No quote is left and every bracket has its partner; otherwise the canonical spelling would be split elsewhere.
bool balanced(const std::string& s) {
  long depth = 0;
  for (const char c : s) {
    if (c == '(' || c == '[') ++depth;
    if (c == ')' || c == ']') --depth;
    if (depth < 0 || c == '"') return false;
  }
  return depth == 0;
}

constexpr long largest_l = 128;

long integer_key(const SchemeName& name, const std::string& key, long least, long greatest) {
  const std::string& text = name.keys.at(key);
  const auto bad = [&] {
    bad_input(
        name.id + ": " + key + " must be an integer from " + std::to_string(least) + " to " + std::to_string(greatest),
        text);
  };
  const bool digits =
      !text.empty() && text.size() < 8 &&
      std::all_of(text.begin() + (text[0] == '-' ? 1 : 0), text.end(), [](char c) { return c >= '0' && c <= '9'; }) &&
      text != "-";
  if (!digits) bad();
  const long value = std::stol(text);
  if (value < least || value > greatest) bad();
  return value;
}

int arity_key(const SchemeName& name) {
  return name.keys.contains("arity") ? static_cast<int>(integer_key(name, "arity", 2, 64)) : 2;
}

// The same scheme has one name: the space in its canonical order, arity 2 not said.
std::string canonical_id(SchemeName name, const Space& space) {
  if (name.keys.contains("space")) name.keys["space"] = space.to_string();
  if (name.keys.contains("arity") && arity_key(name) == 2) name.keys.erase("arity");
  return name.to_string();
}

Space polynomials(unsigned order) { return Space::one_frequency(order, {}); }

// sigma of a space, with what is true of every exponential B-spline.
Scheme approximating(const SchemeName& name, const Space& space, const std::string& source) {
  Scheme s = Scheme::from_symbol(canonical_id(name, space), bspline_symbol(space, arity_key(name)), arity_key(name),
                                 level_parameters(space));
  s.title = "exponential B-spline of {" + space.to_string() + "}";
  s.source = source;
  s.space = space;
  s.claims.push_back({"symmetric", "", source});
  if (space.polynomial_order() > 0) s.claims.push_back({"sum-rules", std::to_string(space.polynomial_order()), source});
  s.claims.push_back({"generates", space.to_string(), source});
  if (space.polynomial_order() > 0)
    s.claims.push_back(
        {"reproduces", polynomials(std::min(2U, space.polynomial_order())).to_string(), "Conti and Romani 2011"});
  s.claims.push_back({"maximal", space.to_string(), ""});
  s.claims.push_back({"well-defined", "", source});
  return s;
}

Scheme interpolating(const SchemeName& name, const Space& space, const std::string& source) {
  if (arity_key(name) != 2)
    bad_input(name.id + ": interpolating schemes of this version are binary, arity", name.keys.at("arity"));
  Scheme s = Scheme::from_symbol(canonical_id(name, space), interpolating_symbol(space), 2, level_parameters(space));
  s.title = std::to_string(space.dimension()) + "-point interpolating scheme of {" + space.to_string() + "}";
  s.source = source;
  s.space = space;
  s.claims.push_back({"interpolatory", "", source});
  s.claims.push_back({"symmetric", "", source});
  if (space.polynomial_order() > 0) s.claims.push_back({"sum-rules", std::to_string(space.polynomial_order()), source});
  s.claims.push_back({"generates", space.to_string(), source});
  s.claims.push_back({"reproduces", space.to_string(), source});
  s.claims.push_back({"maximal", space.to_string(), source});
  s.claims.push_back({"well-defined", "", source});
  return s;
}

Scheme stationary_mask(const SchemeName& name) {
  const int arity = arity_key(name);
  std::string text = trimmed(name.keys.at("coefficients"));
  if (text.size() >= 2 && text.front() == '[' && text.back() == ']') text = text.substr(1, text.size() - 2);
  const auto pieces = split_list(text);
  if (pieces.empty()) bad_input("mask: no coefficients", name.keys.at("coefficients"));
  if (pieces.size() > 4096) bad_input("mask: too many coefficients", std::to_string(pieces.size()));
  std::vector<RationalFunction> c;
  for (const auto& p : pieces) c.push_back(parse_rational_function(p));
  const long length = static_cast<long>(c.size());
  const bool given = name.keys.contains("lowest");
  const Laurent a(given ? integer_key(name, "lowest", -1000000, 1000000) : -((length - 1) / 2), std::move(c));
  std::vector<Parameter> parameters;
  for (const auto& v : a.variables()) parameters.push_back({v, Parameter::Scope::constant, std::nullopt});
  Scheme s = Scheme::from_symbol(name.to_string(), a, arity, std::move(parameters));
  s.title = "stationary mask";
  return s;
}

std::vector<CatalogEntry::Key> sigma_keys(const std::string& n_help) {
  return {{"n", n_help, true}, {"arity", "arity m, 2 if absent", false}};
}

CatalogEntry family_entry(const std::string& family, const std::string& space, const std::string& equation) {
  const std::string source = "romani2009 " + equation;
  return {family,
          "approximating scheme of " + space,
          source,
          sigma_keys("n of " + space),
          {family + ":n=1", family + ":n=2", family + ":n=3", family + ":n=2,arity=3"},
          [family, source](const SchemeName& name) {
            return approximating(
                name, family_space(family, static_cast<unsigned>(integer_key(name, "n", 1, 2 * largest_l))), source);
          }};
}

std::vector<CatalogEntry> build_catalog() {
  std::vector<CatalogEntry> list;
  list.push_back({"bspline",
                  "polynomial B-spline",
                  "Lane and Riesenfeld 1980",
                  sigma_keys("degree"),
                  {"bspline:n=1", "bspline:n=2", "bspline:n=3", "bspline:n=2,arity=3", "bspline:n=3,arity=4"},
                  [](const SchemeName& name) {
                    const auto n = static_cast<unsigned>(integer_key(name, "n", 0, 2 * largest_l));
                    Scheme s = approximating(name, polynomials(n + 1), "Lane and Riesenfeld 1980");
                    s.title = "B-spline of degree " + std::to_string(n);
                    return s;
                  }});
  list.push_back(
      {"exponential-bspline",
       "sigma of any exponential-polynomial space",
       "romani2009 (2)",
       {{"space", "comma list of functions, e.g. \"1,x,exp(t*x),exp(-t*x)\"", true},
        {"arity", "arity m, 2 if absent", false}},
       {"exponential-bspline:space=\"1,exp(t*x),exp(-t*x)\"", "exponential-bspline:space=\"cos(s*x),sin(s*x)\"",
        "exponential-bspline:space=\"1,x,exp(s*x),exp(-s*x),exp(t*x),exp(-t*x)\"",
        "exponential-bspline:arity=3,space=\"1,x,cosh(t*x),sinh(t*x)\""},
       [](const SchemeName& name) {
         return approximating(name, Space::parse(name.keys.at("space")), "romani2009 (2)");
       }});
  list.push_back(family_entry("mixed", "{1, ..., x^n, e^{+-tx}}", "(3)"));
  list.push_back(family_entry("harmonic", "{1, x, e^{+-jtx}, j <= n}", "(9)"));
  list.push_back(family_entry("resonant", "{1, x, x^r e^{+-tx}, r < n}", "(13)"));
  list.push_back(
      {"interpolating",
       "the 2l-point interpolating scheme of a space of dimension 2l",
       "romani2009 (16)-(19), corrected",
       {{"space", "comma list of functions", false},
        {"family", "mixed, harmonic or resonant; with l", false},
        {"l", "2l points", false},
        {"arity", "2", false}},
       {"interpolating:family=mixed,l=2", "interpolating:family=mixed,l=3", "interpolating:family=harmonic,l=3",
        "interpolating:family=resonant,l=3", "interpolating:family=mixed,l=4", "interpolating:family=harmonic,l=4",
        "interpolating:family=resonant,l=4", "interpolating:space=\"1,x,exp(s*x),exp(-s*x),exp(t*x),exp(-t*x)\"",
        "interpolating:space=\"1,x,cos(t*x),sin(t*x),cos(3*t*x),sin(3*t*x)\"",
        "interpolating:space=\"1,x,x^2,x^3,cos(t*x),sin(t*x),x*cos(t*x),x*sin(t*x)\"",
        "interpolating:space=\"exp(t*x),exp(-t*x)\"", "interpolating:space=\"cosh(x),sinh(x),1,x\""},
       [](const SchemeName& name) {
         const bool family = name.keys.contains("family");
         if (family == name.keys.contains("space"))
           bad_input("interpolating: give either space=... or family=... with l=...", name.to_string());
         if (!family) {
           if (name.keys.contains("l"))
             bad_input("interpolating: l goes with family, not with space", name.to_string());
           return interpolating(name, Space::parse(name.keys.at("space")), "romani2009 (16)-(19), corrected");
         }
         if (!name.keys.contains("l")) bad_input("interpolating: l is missing", name.to_string());
         const std::string& f = name.keys.at("family");
         const auto l = static_cast<unsigned>(integer_key(name, "l", 2, largest_l));
         return interpolating(name, family_space(f, family_member(f, l)), "romani2009 Corollary 11");
       }});
  list.push_back({"dd",
                  "Deslauriers-Dubuc 2l-point",
                  "Deslauriers and Dubuc 1989",
                  {{"l", "2l points", true}},
                  {"dd:l=1", "dd:l=2", "dd:l=3", "dd:l=8"},
                  [](const SchemeName& name) {
                    Scheme s = interpolating(
                        name, polynomials(2 * static_cast<unsigned>(integer_key(name, "l", 1, largest_l))),
                        "Deslauriers and Dubuc 1989");
                    s.title = "Deslauriers-Dubuc " + std::to_string(s.space->dimension()) + "-point scheme";
                    return s;
                  }});
  list.push_back(
      {"tension4",
       "4-point scheme with tension v^0",
       "beccari2007 (3), (7)",
       {},
       {"tension4"},
       [](const SchemeName& name) { return interpolating(name, family_space("mixed", 1), "beccari2007 (3), (7)"); }});
  list.push_back({"mask",
                  "any stationary mask; names in the coefficients are constant parameters",
                  "",
                  {{"coefficients", "comma list of expressions", true},
                   {"lowest", "index of the first; centred if absent", false},
                   {"arity", "arity m, 2 if absent", false}},
                  {"mask:coefficients=\"1/8,1/2,3/4,1/2,1/8\",lowest=-2", "mask:coefficients=\"1/4,3/4,3/4,1/4\"",
                   "mask:coefficients=\"-w,0,1/2+w,1,1/2+w,0,-w\",lowest=-3"},
                  stationary_mask});
  return list;
}

}  // namespace

std::string SchemeName::to_string() const {
  std::string s = id;
  char join = ':';
  for (const auto& [key, value] : keys) {
    const bool quote = value.find(',') != std::string::npos;
    s += join + key + "=" + (quote ? "\"" + value + "\"" : value);
    join = ',';
  }
  return s;
}

SchemeName parse_scheme_name(std::string_view text) {
  SchemeName name;
  const std::string whole = trimmed(text);
  const auto colon = whole.find(':');
  name.id = trimmed(whole.substr(0, colon));
  if (name.id.empty()) bad_input("scheme name is empty", whole);
  if (colon == std::string::npos) return name;
  std::string key;
  for (const auto& piece : split_list(std::string_view(whole).substr(colon + 1))) {
    if (starts_with_key(piece)) {
      const auto equals = piece.find('=');
      key = piece.substr(0, equals);
      if (!name.keys.emplace(key, piece.substr(equals + 1)).second) bad_input("key is given twice in scheme name", key);
    } else {
      if (key.empty()) bad_input("scheme name: expected key=value", piece);
      name.keys[key] += "," + piece;
    }
  }
  for (auto& [k, value] : name.keys) {
    value = unquoted(value);
    if (!balanced(value)) bad_input("quotes or brackets do not match in scheme name", value);
  }
  return name;
}

const std::vector<CatalogEntry>& catalog() {
  static const std::vector<CatalogEntry> list = build_catalog();
  return list;
}

Scheme make_scheme(std::string_view text) {
  const SchemeName name = parse_scheme_name(text);
  const auto& list = catalog();
  const auto entry = std::find_if(list.begin(), list.end(), [&](const auto& e) { return e.id == name.id; });
  if (entry == list.end()) bad_input("unknown scheme (twoscale list prints them)", name.id);
  for (const auto& [key, value] : name.keys)
    if (std::none_of(entry->keys.begin(), entry->keys.end(), [&, &k = key](const auto& e) { return e.name == k; }))
      bad_input(name.id + ": unknown key", key);
  for (const auto& k : entry->keys)
    if (k.required && !name.keys.contains(k.name)) bad_input(name.id + ": key is missing", k.name);
  return entry->recipe(name);
}

Space family_space(const std::string& family, unsigned n) {
  if (family == "mixed") return Space::one_frequency(n + 1, {{1, 1}});
  if (family == "resonant") return Space::one_frequency(2, {{1, n}});
  if (family == "harmonic") {
    std::vector<std::pair<unsigned, unsigned>> multiples;
    for (unsigned j = 1; j <= n; ++j) multiples.emplace_back(j, 1);
    return Space::one_frequency(2, multiples);
  }
  bad_input("unknown family (mixed, harmonic, resonant)", family);
}

unsigned family_member(const std::string& family, unsigned l) { return family == "mixed" ? 2 * l - 3 : l - 1; }

}  // namespace twoscale
