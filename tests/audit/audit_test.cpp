// SPDX-License-Identifier: GPL-3.0-or-later
// The audit decides what its items say and nothing else: every printed formula is perturbed, and the verdict must
// change.
#include "twoscale/reports/audit.hpp"

#include <gtest/gtest.h>

#include <cctype>

#include "twoscale/symbolic/error.hpp"

namespace twoscale::reports::audit {
namespace {

Verdict verdict_of(const std::string& toml) { return audit(parse_items(toml, "test").at(0)).verdict; }

/// The texts that come from `text` by adding 1 to one number that stands for itself (not within a name).
std::vector<std::string> with_another_number(const std::string& text) {
  std::vector<std::string> result;
  const auto digit = [&](size_t i) { return std::isdigit(static_cast<unsigned char>(text[i])) != 0; };
  for (size_t i = 0; i < text.size(); ++i) {
    if (!digit(i)) continue;
    size_t end = i;
    while (end < text.size() && digit(end)) ++end;
    const bool in_name = i > 0 && (std::isalnum(static_cast<unsigned char>(text[i - 1])) != 0 || text[i - 1] == '_');
    if (!in_name)
      result.push_back(text.substr(0, i) + std::to_string(std::stol(text.substr(i, end - i)) + 1) + text.substr(end));
    i = end;
  }
  return result;
}

/// The item with its decisive statement (the correction, where there is one that is proved) perturbed.
std::vector<Item> mutants(const Item& item, Verdict verdict) {
  const bool correction = verdict == Verdict::corrected;
  const auto with = [&](const Arguments& arguments) {
    Item changed = item;
    if (correction) {
      changed.corrected_by = corrected_decider(item);
      changed.corrected = arguments;
    } else {
      changed.arguments = arguments;
    }
    return changed;
  };
  const Arguments base = correction ? corrected_arguments(item) : item.arguments;
  if (!item.mutation.empty()) {
    Arguments arguments = base;
    for (const auto& [key, value] : item.mutation) arguments[key] = value;
    return {with(arguments)};
  }
  std::vector<Item> result;
  for (const std::string& key : decider(correction ? corrected_decider(item) : item.decider).printed) {
    const auto at = base.find(key);
    if (at == base.end()) continue;
    for (size_t i = 0; i < at->second.size(); ++i)
      for (const std::string& text : with_another_number(at->second[i])) {
        Arguments arguments = base;
        arguments[key][i] = text;
        result.push_back(with(arguments));
      }
  }
  return result;
}

/// Is the item an identity in variables none of which has a value, without indices?
bool is_free(const Item& item) {
  for (const auto& [key, list] : item.arguments)
    for (const std::string& text : list) {
      if (text.find_first_of("[{") != std::string::npos) return false;
      const size_t equals = text.find('=');
      if (key == "let" && equals != std::string::npos &&
          text.find_first_not_of(" -0123456789/", equals + 1) == std::string::npos)
        return false;
    }
  return true;
}

class Paper : public testing::TestWithParam<std::string> {};

TEST_P(Paper, EveryPrintedFormulaMatters) {
  for (const Item& item : items_of(GetParam())) {
    SCOPED_TRACE(item.paper + " " + item.equation + ": " + item.statement);
    const Result r = audit(item);
    if (item.decider == "not-decided") {
      EXPECT_EQ(r.verdict, Verdict::undecided);
      continue;
    }
    EXPECT_NE(r.verdict, Verdict::undecided) << r.evidence;
    EXPECT_FALSE(r.evidence.empty());
    // A proposed correction is proved, or the item does not propose one.
    EXPECT_EQ(item.correction.empty(), r.verdict != Verdict::corrected) << r.evidence;
    const auto changed = mutants(item, r.verdict);
    EXPECT_FALSE(changed.empty()) << "nothing to perturb";
    // Every number of an identity in free variables matters. At a point (1^2 = 1^3), in indices beyond the support or
    // in a bound that is not sharp some do not, but one at least does.
    const bool all =
        item.mutation.empty() && item.decider == "identity" && r.verdict == Verdict::holds && is_free(item);
    size_t noticed = 0;
    for (const Item& m : changed) {
      bool differs = true;
      try {
        differs = audit(m).verdict != r.verdict;
      } catch (const Error&) {
        differs = item.mutation.empty();  // what cannot be read has no verdict
      }
      noticed += differs ? 1 : 0;
      if (noticed > 0 && !all) break;
      if (all) {
        EXPECT_TRUE(differs) << (r.verdict == Verdict::corrected ? m.corrected : m.arguments).begin()->second[0];
      }
    }
    EXPECT_GT(noticed, 0U);
  }
}

INSTANTIATE_TEST_SUITE_P(Audit, Paper, testing::ValuesIn(papers()), [](const auto& paper) { return paper.param; });

TEST(Audit, CoversThePapers) {
  size_t all = 0;
  for (const auto& [paper, least] :
       {std::pair("beccari2007", 55U), std::pair("hermite2010", 90U), std::pair("jeong2013", 110U),
        std::pair("nuli", 75U), std::pair("romani2009", 165U)}) {
    const auto items = items_of(paper);
    EXPECT_GE(items.size(), least) << paper;
    all += items.size();
  }
  EXPECT_GE(all, 340U);
}

TEST(Audit, FourVerdicts) {
  const std::string head = "[[item]]\nequation = \"(1)\"\nstatement = \"s\"\n";
  EXPECT_EQ(verdict_of(head + R"(decider = "identity"
left = "(x+1)^2"
right = "x^2+2*x+1")"),
            Verdict::holds);
  const std::string wrong = head + R"(decider = "identity"
left = "(x+1)^2"
right = "x^2+3*x+1"
)";
  EXPECT_EQ(verdict_of(wrong), Verdict::fails);
  EXPECT_EQ(verdict_of(wrong + "correction = \"2x\"\ncorrected = { right = \"x^2+2*x+1\" }"), Verdict::corrected);
  // A counterexample is found where the difference vanishes at many small points.
  EXPECT_EQ(verdict_of(head + "decider = \"identity\"\nleft = \"(v-u)^2\"\nright = \"(v-u)^3\""), Verdict::fails);
  // A correction that is not true does not count.
  EXPECT_EQ(verdict_of(wrong + "correction = \"4x\"\ncorrected = { right = \"x^2+4*x+1\" }"), Verdict::fails);
  EXPECT_EQ(verdict_of(head + "decider = \"not-decided\"\nreason = \"r\""), Verdict::undecided);
}

TEST(Audit, FormulasOfItems) {
  const auto holds = [](const std::string& body) {
    return verdict_of("[[item]]\nequation = \"(1)\"\nstatement = \"s\"\ndecider = \"identity\"\n" + body) ==
           Verdict::holds;
  };
  EXPECT_TRUE(holds("cases = [\"n=1..6\"]\nleft = \"[[sum i=1..n: x^{i-1}]]*(x-1)\"\nright = \"x^{n}-1\""));
  EXPECT_TRUE(
      holds("cases = [\"n=2..4\", \"i=0..n-2\"]\nlet = [\"c = coefficients of (1+z)^{n}\"]\nleft = \"c[i]\"\nright = "
            "\"c[n-i]\""));
  EXPECT_TRUE(
      holds("let = [\"c = coefficients of z^(-1)+2*z\"]\nleft = [\"c[-1]\", \"c[0]\", \"c[1]\", \"c[7]\"]\nright = [1, "
            "0, 2, 0]"));
  EXPECT_TRUE(
      holds("let = [\"D = determinant rows 1..3 columns 0..3 without 1 : c=0 -> a ; c=r -> b ; c=3 -> 1\"]\nleft = "
            "\"D\"\nright = \"a*b^2-a*b\""));
  EXPECT_TRUE(holds("let = [\"s = substitute x-2*y at x=y, y=x\"]\nleft = \"s\"\nright = \"y-2*x\""));
  EXPECT_TRUE(holds("let = [\"d = derivative x^3/y by x\"]\nleft = \"d\"\nright = \"3*x^2/y\""));
  EXPECT_TRUE(
      holds("let = [\"L = rules hermite-circle:variant=c2 at s_0=-u, s_1=u\"]\nleft = [\"L_00\", \"L_20\"]\nright = "
            "[\"1/2\", \"0\"]"));
  EXPECT_FALSE(holds("let = [\"D = determinant rows 1..2 columns 1..2 : r>0 -> a\"]\nleft = \"D\"\nright = \"a\""));
}

TEST(Audit, FormulasOnKnots) {
  const auto verdict = [](const std::string& body) {
    return verdict_of("[[item]]\nequation = \"(1)\"\nstatement = \"s\"\ndecider = \"identity\"\n" + body);
  };
  EXPECT_EQ(verdict(R"(let = ["t = knots edges=-1..1"]
left = ["t[2]", "t[-1]"]
right = ["d[0]", "(lambda[-1]-1)*d[-1]"])"),
            Verdict::holds);
  // The piece of a rule is the one at the sample, and values may exchange names.
  const std::string rule =
      R"(let = ["c = rule nuli4 where lambda_0=1/4", "a = d[-1]", "b = d[1]", "d[-1] = b", "d[1] = a",
 "l = 1-lambda[0]", "lambda[0] = l", "e = rule nuli4 where lambda_0=)";
  const std::string sides = "\"]\nleft = \"c[-1]\"\nright = \"e[2]\"";
  EXPECT_EQ(verdict(rule + "3/4" + sides), Verdict::holds);
  EXPECT_EQ(verdict(rule + "1/4" + sides), Verdict::fails);
  for (const char* let : {"c = rule nuli4", "c = rule dd:l=2", "c = spline order=3 rho=3 mu=2 at=x piece=0",
                          "c = spline-coefficients order=3 rho=9 mu=2 edges=0..0",
                          "c = junction nuli4 row=9 alpha=1 "
                          "left=1/2 right=1/2",
                          "c = rule nuli4 where lambda_0"}) {
    const auto items = parse_items("[[item]]\nequation = \"(1)\"\nstatement = \"s\"\ndecider = \"identity\"\nlet = \"" +
                                       std::string(let) + "\"\nleft = 1\nright = 1",
                                   "file");
    EXPECT_THROW(audit(items.at(0)), Error) << let;
  }
}

TEST(Audit, Junctions) {
  const std::string head = "[[item]]\nequation = \"(1)\"\nstatement = \"s\"\nscheme = \"nuli4\"\n";
  const auto at = [&](const char* place, const char* order) {
    return verdict_of(head + "decider = \"junction\"\norder = " + order + "\nat = \"" + place + "\"");
  };
  EXPECT_EQ(at("alpha=3,left=1,right=1/8", "1"), Verdict::holds);
  EXPECT_EQ(at("alpha=3,left=1,right=0", "1"), Verdict::fails);
  EXPECT_EQ(at("alpha=3", "2"), Verdict::fails);
  EXPECT_THROW(at("alpha=a", "1"), Error);
  EXPECT_THROW(at("beta=1", "1"), Error);
  EXPECT_EQ(verdict_of(head + "decider = \"junction\"\norder = 1"), Verdict::fails);  // the crease is an exception
}

TEST(Audit, SaysWhatCannotBeRead) {
  const std::string head = "[[item]]\nequation = \"(1)\"\nstatement = \"s\"\n";
  for (const auto& [text, piece] :
       {std::pair<std::string, std::string>("[[item", "line 1"),
        {"", "[[item]]"},
        {"item = 3", "[[item]]"},
        {"[[item]]\nequation = \"(1)\"\nstatement = \"s\"", "decider"},
        {head + "decider = \"guess\"", "guess"},
        {head + "decider = \"identity\"\nleft = 1\nrihgt = 1", "rihgt"},
        {head + "decider = \"identity\"\nleft = 1.5\nright = 1", "left"},
        {head + "decider = \"identity\"\nleft = \"x\"\nright = \"y\"\ncorrection = \"z\"", "corrected"}}) {
    try {
      parse_items(text, "file");
      ADD_FAILURE() << text;
    } catch (const Error& e) {
      EXPECT_NE(std::string(e.what()).find(piece), std::string::npos) << e.what();
    }
  }
  for (const char* body :
       {"decider = \"identity\"\nleft = \"x+\"\nright = \"y\"",
        "decider = \"identity\"\nleft = \"[[sum i: x]]\"\nright = \"y\"",
        "decider = \"identity\"\nleft = \"x[n]\"\nright = \"y\"",
        "decider = \"identity\"\nlet = \"s = substitute x\"\nleft = \"s\"\nright = \"y\"",
        "decider = \"identity\"\nlet = \"s = substitute x at y\"\nleft = \"s\"\nright = \"y\"",
        "decider = \"identity\"\nlet = \"s = derivative x\"\nleft = \"s\"\nright = \"y\"",
        "decider = \"identity\"\nlet = \"s = rules dd:l=2\"\nleft = \"s\"\nright = \"y\"",
        "decider = \"identity\"\nleft = \"1/0\"\nright = \"y\"", "decider = \"numbers\"\nrelations = \"pi\"",
        "decider = \"claims\"\nscheme = \"dd\"\nclaims = \"reproduces=1\"",
        "decider = \"positive\"\nexpression = \"x\"\ndomain = \"x>0\"",
        "decider = \"exponent\"\nscheme = \"dd:l=2\"\nexponent = 2\nattained = \"perhaps\"",
        "decider = \"identity\"\ncases = \"n=0..99999\"\nleft = 1\nright = 1"}) {
    const auto items = parse_items(head + body, "file");
    EXPECT_THROW(audit(items.at(0)), Error) << body;
  }
}

TEST(Audit, KeyTellsItemsApart) {
  Item item = items_of("jeong2013").at(0);
  const std::string key = item_key(item);
  item.arguments["claims"] = {"continuity=3"};
  EXPECT_NE(item_key(item), key);
}

}  // namespace
}  // namespace twoscale::reports::audit
