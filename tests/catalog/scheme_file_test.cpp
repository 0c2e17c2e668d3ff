// SPDX-License-Identifier: GPL-3.0-or-later
/// Scheme files: what is read, and every way to be wrong, with the place that is named.
#include "twoscale/symbolic/scheme_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>

#include "twoscale/analysis/prove.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"

namespace twoscale::tests {
namespace {

Scheme read(const std::string& text) { return SchemeFile::parse(text, "f.toml").scheme(); }

/// What is said about a text: "LINE:COLUMN: message".
std::string refusal(const std::string& text) {
  try {
    read(text);
    return "read";
  } catch (const Error& e) {
    EXPECT_EQ(e.kind, Error::Kind::bad_input) << e.what();
    const std::string what = e.what();
    EXPECT_EQ(what.rfind("f.toml:", 0), 0U) << what;
    EXPECT_EQ(what.find('\n'), std::string::npos) << what;
    return what.substr(7);
  }
}

const std::string head = "[scheme]\nname = \"a\"\n";
const std::string chaikin = head + "symbol = \"(1+z)^3/(4*z)\"\n";

void expect_refused(const std::string& text, const std::string& place, const std::string& piece) {
  const std::string what = refusal(text);
  EXPECT_EQ(what.rfind(place + (place.ends_with(":") ? "" : ":"), 0), 0U) << what << "\nfor\n" << text;
  EXPECT_NE(what.find(piece), std::string::npos) << what << "\nfor\n" << text;
}

TEST(SchemeFile, SymbolAndPhasesAreTheSameScheme) {
  const Scheme s = read(chaikin);
  EXPECT_EQ(s.id, "a");
  EXPECT_EQ(symbol(s), symbol(make_scheme("bspline:n=2")));
  EXPECT_EQ(s.shift, Rational(1, 2));
  const Scheme t = read(head +
                        "[[phase]]\nresidue = 1\nstencil = {\"0\" = \"3/4\", \"1\" = \"0.25\"}\n"
                        "[[phase]]\nresidue = 0\nstencil = {\"-1\" = \"0.25\", \"0\" = \"3/4\"}\n");
  EXPECT_EQ(symbol(t).coefficients().size(), 4U);
  EXPECT_EQ(symbol(t), symbol(s).shifted(1 - symbol(s).lowest() + symbol(t).lowest() - 1));
  EXPECT_EQ(symbol(read("symbol = \"(1+z)^3/(4*z)\"\n" + head)), symbol(s));  // outside of any table
}

TEST(SchemeFile, ShiftTitleSourceClaims) {
  const Scheme s = read(head +
                        "title = \"t\"\nsource = \"s\"\nshift = \"1/3\"\nsymbol = \"(1+z)^2/2\"\n"
                        "[[claim]]\nclaim = \"generates\"\nsubject = \"x, 1\"\nsource = \"me\"\n"
                        "[[claim]]\nclaim = \"sum-rules\"\nsubject = 2\n");
  EXPECT_EQ(s.title, "t");
  EXPECT_EQ(s.source, "s");
  EXPECT_EQ(s.shift, Rational(1, 3));
  ASSERT_EQ(s.claims.size(), 2U);
  EXPECT_EQ(s.claims[0].subject, "1, x");
  EXPECT_EQ(s.claims[0].source, "me");
  EXPECT_EQ(s.claims[1].subject, "2");
}

TEST(SchemeFile, ConstantParameters) {
  const Scheme s =
      read(head +
           "symbol = \"(1+z)*(w + (1-2*w)*z + w*z^2)\"\n"
           "[parameters.w]\nscope = \"constant\"\ndomain = \"(0, 1/2)\"\ndefault = \"1/4\"\nhelp = \"h\"\n");
  ASSERT_EQ(s.parameters.size(), 1U);
  EXPECT_EQ(s.parameters[0].domain->to_string(), "(0, 1/2)");
  EXPECT_EQ(s.parameters[0].default_value, "1/4");
  EXPECT_EQ(symbol(with_default_values(s)), symbol(read(chaikin)).shifted(1));
  EXPECT_THROW(with_values(s, {{"w", Rational(1, 2)}}), Error);
  EXPECT_NO_THROW(with_values(s, {{"w", Rational(1, 3)}}));
}

/// The cubic-like symbol of {1, x, e^{+-tx}} in three spellings of cosh is the one of the catalogue.
TEST(SchemeFile, FrequenciesAreRewritten) {
  const Laurent expected = symbol(make_scheme("mixed:n=1"));
  for (const auto& [relation, v] :
       {std::pair("2*g^2-1", "g"), std::pair("g^2-2", "(g/2)"), std::pair("2*g*(2+g)", "(g+1)")}) {
    const std::string w(v);
    const Scheme s = read(head + "symbol = \"(1+z)^2*(1+2*" + w + "*z+z^2)/(4*(1+" + w +
                          ")*z^2)\"\n[parameters.g]\nscope = \"level\"\n"
                          "relation = \"" +
                          relation + "\"\n[[claim]]\nclaim = \"generates\"\nsubject = \"1,x,exp(t*x),exp(-t*x)\"\n");
    ASSERT_EQ(level_variables(s).size(), 1U);
    const std::string name = level_variables(s)[0].name;
    EXPECT_EQ(name, w == "g" ? "g" : "v");
    Laurent a = symbol(s);
    if (name != "v") a = a.substitute(name, RationalFunction::variable("v"));
    EXPECT_EQ(a, RationalFunction(a.at_one() / expected.at_one()) * expected) << relation;
    EXPECT_EQ(analysis::prove(s, s.claims).decisions[0].verdict, analysis::Verdict::proved) << relation;
    EXPECT_EQ(s.parameters[0].spelling->name, "g");
  }
}

TEST(SchemeFile, SpaceGivesLevelVariables) {
  const Scheme s =
      read(head +
           "space = \"1, x, exp(t*x), exp(-t*x)\"\nsymbol = \"(1+z)^2*(1+2*v*z+z^2)/(4*(1+v)*z^2)\"\n"
           "[parameters.v]\nscope = \"level\"\ndefault = 2\ndomain = \"[1, 5]\"\n[[claim]]\nclaim = \"generates\"\n");
  EXPECT_EQ(s.claims[0].subject, s.space->to_string());
  EXPECT_EQ(s.parameters[0].default_value, "2");
  EXPECT_EQ(analysis::prove(s, s.claims).decisions[0].verdict, analysis::Verdict::proved);
}

TEST(SchemeFile, OtherRelationsTendToOne) {
  const Scheme s =
      read(head +
           "symbol = \"(1+z)^3*(1 - g + (2*g+2)*z + (1-g)*z^2)/(16*z^2)\"\n[parameters.g]\nscope = \"level\"\n"
           "relation = \"g^2+2*g\"\ndomain = \"(-1, inf)\"\n");
  EXPECT_FALSE(is_stationary(s));
  EXPECT_TRUE(level_variables(s).empty());
  EXPECT_EQ(free_parameters(s), std::vector<std::string>{"v"});
  EXPECT_EQ(*limit_symbol(s), symbol(s).substitute("v", 1));
  EXPECT_EQ(symbol(s).substitute("v", 1), symbol(read(head + "symbol = \"(1+z)^5/(16*z^2)\"\n")));
}

TEST(SchemeFile, LocalParametersAndBlocksAreRead) {
  const Scheme s = read(head +
                        "shift = 0\n[parameters.d]\nscope = \"local\"\noffsets = [1, -1, 0]\n"
                        "[[phase]]\nresidue = 0\nstencil = {\"0\" = 1}\n"
                        "[[phase]]\nresidue = 1\nstencil = {\"0\" = \"d_m1/(d_0+d_m1)\", \"1\" = \"d_0/(d_1+d_0)\"}\n");
  EXPECT_FALSE(is_uniform(s));
  EXPECT_EQ(s.parameters[0].offsets, (std::vector<long>{-1, 0, 1}));
  EXPECT_THROW(symbol(s), Error);
  const Scheme b = read(
      "[scheme]\nname = \"h\"\nblock = 2\n[[phase]]\nresidue = 0\nstencil = {\"0\" = [[1, 0], [0, \"1/2\"]]}\n"
      "[[phase]]\nresidue = 1\nstencil = {\"0\" = [[\"1/2\", \"1/8\"], [\"-3/4\", \"-1/8\"]], \"2\" = [[0, 0], [0, "
      "1]]}\n");
  EXPECT_EQ(b.block, 2);
  ASSERT_EQ(b.phases[1].blocks.size(), 3U);
  EXPECT_EQ(b.phases[1].blocks[0][2], RationalFunction(Rational(-3, 4)));
  EXPECT_TRUE(b.phases[1].blocks[1][0].is_zero());
  EXPECT_THROW(symbol(b), Error);
}

TEST(SchemeFile, TomlErrors) {
  expect_refused("[scheme\nname = 1", "1:8", "");
  expect_refused(head + "title = \"unended\n", "3:", "");
  expect_refused(head + "name = \"b\"\n", "3:", "");
  expect_refused(head + "title = \"\xff\xfe\"\n", "3:", "");
  expect_refused("", "1:1", "[scheme]");
  expect_refused("scheme = 3\n", "1:10", "table");
  expect_refused(std::string("[scheme]\nname = \"") + std::string(1, '\x01') + "\"\n", "2:", "");
}

TEST(SchemeFile, UnknownKeysNameTheNearest) {
  expect_refused(head + "artiy = 3\n", "3:1", "did you mean arity?: artiy");
  expect_refused(chaikin + "colour = \"blue\"\n", "4:1", "none of");
  expect_refused(chaikin + "[parameter.w]\nscope=\"constant\"\n", "4:2", "did you mean parameters?");
  expect_refused(chaikin + "[parameters.w]\nscop = \"constant\"\n", "5:1", "did you mean scope?");
  expect_refused(chaikin + "[[claims]]\nclaim = \"symmetric\"\n", "4:3", "did you mean claim?");
  expect_refused(chaikin + "[[claim]]\nclaim = \"symetric\"\n", "5:9", "did you mean symmetric?");
  expect_refused(chaikin + "[parameters.w]\nscope = \"levle\"\n", "5:9", "did you mean level?");
}

TEST(SchemeFile, WrongTypes) {
  expect_refused(head + "arity = \"3\"\nsymbol = \"1+z\"\n", "3:9", "without quotes");
  expect_refused(head + "arity = 2.5\nsymbol = \"1+z\"\n", "3:9", "floating-point");
  expect_refused(head + "title = 3\nsymbol = \"1+z\"\n", "3:9", "in quotes");
  expect_refused(head + "title = true\nsymbol = \"1+z\"\n", "3:9", "string");
  expect_refused(head + "shift = 0.5\nsymbol = \"1+z\"\n", "3:9", "write it in quotes");
  expect_refused("[scheme]\nname = \"a b\"\nsymbol = \"1+z\"\n", "2:8", "a b");
  expect_refused("[scheme]\nname = \"\"\nsymbol = \"1+z\"\n", "2:8", "name");
  expect_refused("[scheme]\nsymbol = \"1+z\"\n", "1:1", "name");
  expect_refused(head + "[[phase]]\nresidue = 0\nstencil = [1]\n", "5:11", "table");
  expect_refused(head + "[[phase]]\nresidue = 0\nstencil = {\"0\" = 0.5}\n", "5:18", "floating-point");
  expect_refused(head + "[phase]\nresidue = 0\n", "3:1", "double brackets");
  expect_refused(head + "[[phase]]\nresidue = 0\n", "3:1", "stencil");
  expect_refused(head + "phase = [1]\n", "3:1", "unknown key");
}

TEST(SchemeFile, RangesAndPhases) {
  expect_refused(head + "arity = 1\nsymbol = \"1+z\"\n", "3:9", "between 2 and 64");
  expect_refused(head + "arity = 65\nsymbol = \"1+z\"\n", "3:9", "65");
  expect_refused(head + "block = 9\nsymbol = \"1+z\"\n", "3:9", "9");
  expect_refused(head, "2:8", "symbol or one [[phase]]");
  const std::string even = "[[phase]]\nresidue = 0\nstencil = {\"0\" = 1}\n";
  expect_refused(head + even, "4:11", "needs the residue: 1");
  expect_refused(head + even + even, "7:11", "given twice");
  expect_refused(chaikin + even, "3:10", "not both");
  expect_refused("symbol = \"1+z\"\n" + chaikin, "1:10", "twice");
  expect_refused(head + even + "[[phase]]\nresidue = 2\nstencil = {\"0\" = 1}\n", "7:11", "less than the arity 2");
  expect_refused(head + even + "[[phase]]\nresidue = -1\nstencil = {\"0\" = 1}\n", "7:11", "-1");
  expect_refused(head + even + "[[phase]]\nresidue = 1\nstencil = {}\n", "8:11", "empty");
  for (const char* offset : {"01", "+1", "a", "1.0", "-0", "", "9999"})
    expect_refused(head + even + "[[phase]]\nresidue = 1\nstencil = {\"" + offset + "\" = 1}\n", "8:12", "offsets");
  expect_refused(head + even + "[[phase]]\nresidue = 1\nstencil = {\"0\" = 1, \"0\" = 2}\n", "8:27", "redefine");
  expect_refused(head + even + "[[phase]]\nresidue = 1\nstencil = {\"0\" = [[1, 0], [0, 1]]}\n", "8:20",
                 "one expression");
  expect_refused(head + even + "[[phase]]\nresidue = 1\nstencil = {\"0\" = [[1, 0], [0]]}\n", "8:27", "square");
  expect_refused("[scheme]\nname = \"a\"\nblock = 2\n[[phase]]\nresidue = 0\nstencil = {\"0\" = 1}\n", "6:18",
                 "2 arrays");
}

TEST(SchemeFile, Expressions) {
  expect_refused(head + "symbol = \"(1+z\"\n", "3:15", "symbol");
  expect_refused(head + "symbol = \"1+z*#\"\n", "3:15", "#");
  expect_refused(head + "symbol = \"1+z/(1+z)\"\n", "3:10", "not a Laurent polynomial");
  expect_refused(head + "symbol = \"1-z\"\n", "3:10", "sum 0");
  expect_refused(head + "symbol = \"0\"\n", "3:10", "zero");
  expect_refused(head + "symbol = \"sqrt(z)\"\n", "3:10", "symbol");
  expect_refused(head + "symbol = \"1+z^5000\"\n", "3:19", "too large");
  expect_refused(head + "symbol = \"1+z^4096\"\n", "3:10", "4096 coefficients");
  expect_refused(head + "symbol = \"(1+z)*(w+1)/2\"\n", "3:18", "not declared: w");
  expect_refused(head + "shift = \"1/0\"\nsymbol = \"1+z\"\n", "3:13", "shift");
  expect_refused(head + "shift = \"pi\"\nsymbol = \"1+z\"\n", "3:9", "shift");
  expect_refused(head + "space = \"1, x, exp(t*x)\"\nsymbol = \"1+z\"\n", "3:9", "exp(-t*x)");
  expect_refused(head +
                     "[[phase]]\nresidue = 0\nstencil = {\"0\" = \"1-q\", \"1\" = \"q\"}\n[[phase]]\nresidue = "
                     "1\nstencil = {\"0\" = 1}\n",
                 "5:21", "not declared: q");
}

TEST(SchemeFile, Parameters) {
  const auto with = [](const std::string& parameter) {
    return head + "symbol = \"(1+z)*(w + (1-2*w)*z + w*z^2)\"\n[parameters.w]\n" + parameter;
  };
  expect_refused(with(""), "4:1", "scope");
  expect_refused(with("scope = \"constant\"\ndomain = \"0..1\"\n"), "6:10", "not an interval");
  expect_refused(with("scope = \"constant\"\ndomain = \"[1, 0]\"\n"), "6:10", "smaller");
  expect_refused(with("scope = \"constant\"\ndomain = \"(0, 1/2)\"\ndefault = \"1/2\"\n"), "7:11", "outside (0, 1/2)");
  expect_refused(with("scope = \"constant\"\ndefault = \"1/0\"\n"), "6:15", "default");
  expect_refused(with("scope = \"constant\"\nrelation = \"w^2\"\n"), "6:12", "scope level");
  expect_refused(with("scope = \"constant\"\noffsets = [0]\n"), "6:11", "scope local");
  expect_refused(with("scope = \"level\"\n"), "5:9", "relation");
  expect_refused(with("scope = \"level\"\nrelation = \"1/w\"\ndomain = \"(0, 1)\"\n"), "6:12", "not a polynomial");
  expect_refused(with("scope = \"level\"\nrelation = \"w^2\"\n"), "6:12", "domain");
  expect_refused(with("scope = \"level\"\nrelation = \"w^2+y\"\ndomain = \"(0, 1)\"\n"), "6:17", "y");
  expect_refused(with("scope = \"local\"\n"), "5:9", "offsets");
  expect_refused(with("scope = \"local\"\noffsets = []\n"), "6:11", "non-empty");
  expect_refused(with("scope = \"local\"\noffsets = [0, 0]\n"), "6:15", "twice");
  expect_refused(with("scope = \"local\"\noffsets = [0, \"1\"]\n"), "6:15", "without quotes");
  expect_refused(with("scope = \"local\"\noffsets = [0]\n"), "3:18", "NAME_0");
  expect_refused(with("scope = \"constant\"\n[parameters.q]\nscope = \"constant\"\n"), "6:13",
                 "declared and not used: q");
  for (const char* name : {"z", "x", "pi", "I", "exp"})
    expect_refused(chaikin + "[parameters." + name + "]\nscope = \"constant\"\n", "4:13", name);
  expect_refused(chaikin + "[parameters.a-b]\nscope = \"constant\"\n", "4:13", "a-b");
  expect_refused(head +
                     "symbol = \"(1+z)*(t+g)\"\n[parameters.t]\nscope = \"constant\"\n[parameters.g]\nscope = "
                     "\"level\"\nrelation = \"2*g^2-1\"\n",
                 "6:13", "that of a frequency");
}

TEST(SchemeFile, Claims) {
  const auto claim = [](const std::string& text) { return chaikin + "[[claim]]\n" + text; };
  expect_refused(claim("subject = 1\n"), "4:1", "claim");
  expect_refused(claim("claim = \"reproduces\"\n"), "5:9", "space");
  expect_refused(claim("claim = \"reproduces\"\nsubject = \"1, y\"\n"), "6:15", "y");
  expect_refused(claim("claim = \"sum-rules\"\n"), "5:9", "order");
  expect_refused(claim("claim = \"sum-rules\"\nsubject = 0\n"), "6:11", "order");
  expect_refused(claim("claim = \"continuity\"\nsubject = \"one\"\n"), "6:11", "one");
  expect_refused(claim("claim = \"symmetric\"\nsubject = \"x\"\n"), "6:11", "no subject");
  expect_refused(claim("claim = \"symmetric\"\n[[claim]]\nclaim = \"symmetric\"\n"), "7:9", "twice");
}

TEST(SchemeFile, FilesThatCannotBeRead) {
  const auto kind = [](const std::string& path) {
    try {
      make_scheme(path);
    } catch (const Error& e) {
      EXPECT_NE(std::string(e.what()).find(path.substr(0, path.find(':'))), std::string::npos) << e.what();
      return e.kind;
    }
    ADD_FAILURE() << path;
    return Error::Kind::undecided;
  };
  EXPECT_EQ(kind("no-such-file.toml"), Error::Kind::io);
  EXPECT_EQ(kind("./no-such-file"), Error::Kind::io);
  EXPECT_EQ(kind("/"), Error::Kind::io);
  EXPECT_EQ(kind("/dev/zero"), Error::Kind::bad_input);  // more than 1 MiB
}

TEST(SchemeFile, NamesAndPaths) {
  const std::string path = ::testing::TempDir() + "twoscale-scheme-file.toml";
  std::ofstream(path) << head + "symbol = \"(1+z)*(w + (1-2*w)*z + w*z^2)\"\n[parameters.w]\nscope = \"constant\"\n";
  EXPECT_EQ(make_scheme(path).id, "a");
  const Scheme s = make_scheme(path + ":w=0.25");
  EXPECT_EQ(s.id, "a:w=1/4");
  EXPECT_TRUE(s.parameters.empty());
  EXPECT_EQ(symbol(s), symbol(read(chaikin)).shifted(1));
  EXPECT_THROW(make_scheme(path + ":u=1"), Error);
  EXPECT_THROW(make_scheme(path + ":w=pi"), Error);
  std::remove(path.c_str());
}

TEST(SchemeFile, TheTemplateWorksAndExplainsEveryKey) {
  const std::string text = scheme_file_template("my-scheme");
  const Scheme s = read(text);
  EXPECT_EQ(s.id, "my-scheme");
  for (const auto& d : analysis::prove(s, s.claims).decisions)
    EXPECT_EQ(d.verdict, analysis::Verdict::proved) << d.claim;
  for (const auto& k : scheme_file_keys()) {
    EXPECT_NE(text.find(std::string("# ") + k.key + ": " + type_text(k.type)), std::string::npos) << k.key;
    EXPECT_NE(text.find(k.help), std::string::npos) << k.key;
  }
  // The symbol that is commented out is that of the phases.
  const auto at = text.find("#symbol = \"") + 11;
  const std::string symbol_text = text.substr(at, text.find('"', at) - at);
  EXPECT_EQ(symbol(read(head + "arity = 3\nsymbol = \"" + symbol_text + "\"\n[parameters.b]\nscope = \"constant\"\n")),
            symbol(s));
  EXPECT_THROW(scheme_file_template("a b"), Error);
  EXPECT_THROW(scheme_file_template(""), Error);
  EXPECT_THROW(scheme_file_template("../x"), Error);
}

/// A key of the schema is accepted where the schema has it (with any value of its type, whatever is said then), and
/// nowhere is a key required that the schema does not require.
TEST(SchemeFile, SchemaIsTheParser) {
  std::set<std::string> tables;
  for (const auto& k : scheme_file_keys()) {
    tables.insert(k.table);
    std::string value;
    switch (k.type) {
      case SchemeFileKey::Type::integer: value = "0"; break;
      case SchemeFileKey::Type::integers: value = "[0]"; break;
      case SchemeFileKey::Type::stencil: value = "{\"0\" = 1}"; break;
      default: value = "\"a\"";
    }
    const std::string table = k.table == std::string("parameters.NAME") ? "[parameters.NAME]"
                              : k.table == std::string("scheme")        ? "[scheme]"
                                                                        : std::string("[[") + k.table + "]]";
    const std::string what = refusal(table + "\n" + k.key + " = " + value + "\n");
    EXPECT_EQ(what.find("unknown key"), std::string::npos) << what;
    const std::string wrong = refusal(table + "\n" + k.key + " = 1979-05-27\n");
    EXPECT_EQ(wrong.find("unknown key"), std::string::npos) << wrong;
  }
  EXPECT_EQ(tables, (std::set<std::string>{"scheme", "parameters.NAME", "phase", "claim"}));
}

TEST(SchemeFile, ClaimNamesAreThoseOfTheProver) {
  for (const auto& name : analysis::claim_names()) {
    const std::string subject = name == "generates" || name == "reproduces" || name == "maximal" ? "subject = \"1\"\n"
                                : name == "sum-rules" || name == "continuity"                    ? "subject = 1\n"
                                                                                                 : "";
    EXPECT_EQ(read(chaikin + "[[claim]]\nclaim = \"" + name + "\"\n" + subject).claims.at(0).name, name);
  }
}

// ---- The files of the catalogue

TEST(EmbeddedSchemes, NamesAreFileNames) {
  EXPECT_GE(embedded_scheme_files().size(), 6U);
  for (const auto& [name, text] : embedded_scheme_files()) {
    const SchemeFile file = SchemeFile::parse(text, name);
    EXPECT_EQ(file.name(), name);
    EXPECT_FALSE(file.title().empty()) << name;
    EXPECT_FALSE(file.source().empty()) << name;
  }
}

TEST(EmbeddedSchemes, ClaimsAreProved) {
  for (const auto& [name, text] : embedded_scheme_files()) {
    const Scheme s = make_scheme(name);
    EXPECT_FALSE(s.claims.empty()) << name;
    for (const auto& d : analysis::prove(s, s.claims).decisions)
      EXPECT_EQ(d.verdict, analysis::Verdict::proved) << name << " " << d.claim << " " << d.subject << " " << d.witness;
  }
}

/// Members that have names of their own.
TEST(EmbeddedSchemes, KnownMembers) {
  const auto same = [](const std::string& a, const std::string& b) {
    EXPECT_EQ(symbol(make_scheme(a)), symbol(make_scheme(b))) << a << " " << b;
  };
  same("four-point:w=1/16", "dd:l=2");
  same("six-point:theta=3/256", "dd:l=3");
  same("six-point:theta=0", "dd:l=2");
  same("corner-cutting:w=1/4", "bspline:n=2");
}

}  // namespace
}  // namespace twoscale::tests
