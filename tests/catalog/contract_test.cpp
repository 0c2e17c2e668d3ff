// SPDX-License-Identifier: GPL-3.0-or-later
/// What every entry of the catalogue has to satisfy. The names come from the catalogue: no entry can be forgotten.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <set>

#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/expression.hpp"
#include "twoscale/symbolic/mary_interpolatory.hpp"

namespace twoscale::tests {
namespace {

std::vector<std::string> examples() {
  std::vector<std::string> list;
  for (const auto& entry : catalog()) list.insert(list.end(), entry.examples.begin(), entry.examples.end());
  return list;
}

class Contract : public ::testing::TestWithParam<std::string> {
 protected:
  void SetUp() override { scheme_ = make_scheme(GetParam()); }
  bool scalar() const { return scheme_.block == 1 && is_uniform(scheme_); }
  Scheme scheme_;
};

TEST_P(Contract, IdMakesTheSameScheme) {
  const Scheme again = make_scheme(scheme_.id);
  EXPECT_EQ(again.id, scheme_.id);
  EXPECT_EQ(again.arity, scheme_.arity);
  EXPECT_EQ(again.shift, scheme_.shift);
  EXPECT_EQ(again.title, scheme_.title);
  EXPECT_FALSE(scheme_.title.empty());
  ASSERT_EQ(again.phases.size(), scheme_.phases.size());
  for (size_t s = 0; s < again.phases.size(); ++s) {
    EXPECT_EQ(again.phases[s].lowest, scheme_.phases[s].lowest);
    EXPECT_EQ(again.phases[s].blocks, scheme_.phases[s].blocks);
  }
}

TEST_P(Contract, IdIsInCanonicalSpelling) {
  EXPECT_EQ(parse_scheme_name(scheme_.id).to_string(), scheme_.id);
  EXPECT_EQ(parse_scheme_name(scheme_.id).id, parse_scheme_name(GetParam()).id);
}

TEST_P(Contract, OneStencilAPhase) {
  ASSERT_GE(scheme_.arity, 2);
  ASSERT_EQ(scheme_.phases.size(), static_cast<size_t>(scheme_.arity));
  for (const Stencil& s : scheme_.phases) {
    EXPECT_FALSE(s.blocks.empty());
    for (const auto& b : s.blocks) {
      EXPECT_EQ(b.size(), static_cast<size_t>(scheme_.block * scheme_.block));
      for (const auto& x : b) EXPECT_TRUE(x.is_canonical());
    }
  }
}

TEST_P(Contract, PhasesAndSymbolAgree) {
  if (!scalar()) return;  // a statement about scalar symbols
  const Laurent a = symbol(scheme_);
  EXPECT_TRUE(a.is_canonical());
  const long m = scheme_.arity;
  long entries = 0;  // that are not zero
  for (long s = 0; s < m; ++s) {
    const Stencil& stencil = scheme_.phases[static_cast<size_t>(s)];
    for (size_t h = 0; h < stencil.blocks.size(); ++h) {
      EXPECT_EQ(stencil.blocks[h][0], a.coefficient(s - m * (stencil.lowest + static_cast<long>(h))));
      entries += stencil.blocks[h][0].is_zero() ? 0 : 1;
    }
  }
  EXPECT_EQ(entries, std::count_if(a.coefficients().begin(), a.coefficients().end(),
                                   [](const auto& c) { return !c.is_zero(); }));
}

TEST_P(Contract, ParametersAreTheVariablesOfTheMask) {
  std::set<std::string> declared;
  for (const auto& p : scheme_.parameters) {
    EXPECT_TRUE(declared.insert(p.name).second) << p.name << " twice";
    EXPECT_EQ(p.frequency.has_value(), p.scope == Parameter::Scope::level) << p.name;
  }
  if (!scalar()) return;  // a statement about scalar symbols
  for (const auto& v : symbol(scheme_).variables()) EXPECT_TRUE(declared.contains(v)) << v;
}

TEST_P(Contract, ShiftIsTheCentre) {
  if (!scalar()) return;  // a statement about scalar symbols
  const auto centre = symbol(scheme_).centre_of_symmetry();
  if (!centre) return;
  EXPECT_EQ(scheme_.shift, *centre / Rational(scheme_.arity - 1));
  if (scheme_.space) {
    const bool odd_length = symbol(scheme_).coefficients().size() % 2 == 1;
    EXPECT_EQ(*centre, odd_length ? Rational(0) : Rational(1, 2));  // masks are centred on 0 or 1/2
  }
}

TEST_P(Contract, LimitIsTheStationarySchemeOfTheSameDimension) {
  if (!scalar()) return;  // a statement about scalar symbols
  const auto limit = limit_symbol(scheme_);
  ASSERT_TRUE(limit.has_value());
  for (const auto& c : limit->coefficients())
    for (const auto& v : c.variables())
      for (const auto& level : level_variables(scheme_)) EXPECT_NE(v, level.name);
  if (!scheme_.space) return;
  const Space polynomials = Space::one_frequency(scheme_.space->dimension(), {});
  const Laurent spline = bspline_symbol(polynomials, scheme_.arity);
  if (scheme_.reproduced) {  // an exponential B-spline times a factor
    EXPECT_TRUE(Laurent::quotient(*limit, spline).has_value());
  } else if (is_interpolatory(scheme_)) {
    EXPECT_EQ(*limit, mary_interpolating_symbol(polynomials, scheme_.arity));
  } else {
    EXPECT_EQ(*limit, spline);
  }
  EXPECT_EQ(limit->at_one().constant(), Rational(scheme_.arity));
}

TEST_P(Contract, ClaimsCanBeRead) {
  static const std::set<std::string> known = {"interpolatory", "generates",    "reproduces", "maximal",
                                              "symmetric",     "sum-rules",    "continuity", "spectrum",
                                              "contractive",   "well-defined", "support"};
  std::set<std::pair<std::string, std::string>> seen;
  for (const Claim& c : scheme_.claims) {
    EXPECT_TRUE(known.contains(c.name)) << c.name;
    EXPECT_TRUE(seen.emplace(c.name, c.subject).second) << c.name << " twice";
    if (c.name == "generates" || c.name == "reproduces" || c.name == "maximal") {
      EXPECT_NO_THROW({
        const Space space = Space::parse(c.subject);
        EXPECT_EQ(space.to_string(), c.subject);
      }) << c.name
         << "=" << c.subject;
    } else if (c.name == "sum-rules") {
      EXPECT_GT(Rational::parse(c.subject).to_long(), 0);
    }
  }
}

/// Claims that are decided by looking.
TEST_P(Contract, EasyClaimsAreTrue) {
  if (!scalar()) return;  // a statement about scalar symbols
  const Laurent a = symbol(scheme_);
  for (const Claim& c : scheme_.claims) {
    if (c.name == "interpolatory") {
      EXPECT_TRUE(is_interpolatory(scheme_));
    } else if (c.name == "symmetric") {
      EXPECT_TRUE(a.centre_of_symmetry().has_value());
    } else if (c.name == "sum-rules") {
      for (long r = 0; r < Rational::parse(c.subject).to_long(); ++r) {
        std::vector<RationalFunction> sums(static_cast<size_t>(scheme_.arity));
        for (long i = a.lowest(); i <= a.highest(); ++i)
          sums[static_cast<size_t>(((i % scheme_.arity) + scheme_.arity) % scheme_.arity)] +=
              RationalFunction(Rational(i).pow(r)) * a.coefficient(i);
        for (const auto& s : sums) EXPECT_EQ(s, sums[0]) << "power " << r;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Catalog, Contract, ::testing::ValuesIn(examples()), [](const auto& example) {
  std::string name;
  for (const char c : example.param) name += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  return std::to_string(example.index) + "_" + name;
});

// ---- The catalogue as a whole

TEST(Catalog, EntriesAreComplete) {
  std::set<std::string> ids;
  for (const auto& entry : catalog()) {
    EXPECT_TRUE(ids.insert(entry.id).second) << entry.id << " twice";
    EXPECT_FALSE(entry.summary.empty()) << entry.id;
    EXPECT_FALSE(entry.examples.empty()) << entry.id;
    std::set<std::string> keys;
    for (const auto& k : entry.keys) {
      EXPECT_TRUE(keys.insert(k.name).second) << entry.id << " " << k.name;
      EXPECT_FALSE(k.help.empty()) << entry.id << " " << k.name;
    }
    for (const auto& e : entry.examples) EXPECT_EQ(parse_scheme_name(e).id, entry.id);
  }
  for (const char* id :
       {"bspline", "exponential-bspline", "mixed", "harmonic", "resonant", "interpolating", "dd", "tension4", "mask"})
    EXPECT_TRUE(ids.contains(id)) << id;
}

std::string refusal(const std::string& name) {
  try {
    make_scheme(name);
    return "made";
  } catch (const Error& e) {
    EXPECT_EQ(e.kind, Error::Kind::bad_input) << name;
    return e.what();
  }
}

TEST(Catalog, UnknownAndMissingKeysAreNamed) {
  for (const auto& entry : catalog()) {
    const std::string example = entry.examples[0];
    const std::string more = example + (example.find(':') == std::string::npos ? ":" : ",") + "colour=blue";
    EXPECT_NE(refusal(more).find("colour"), std::string::npos) << more;
    for (const auto& k : entry.keys)
      if (k.required) {
        EXPECT_NE(refusal(entry.id).find("missing"), std::string::npos) << entry.id;
      }
  }
  EXPECT_NE(refusal("nosuchscheme:n=1").find("nosuchscheme"), std::string::npos);
}

TEST(Catalog, UnusableValuesAreNamed) {
  const auto names = [](const char* scheme, const char* piece) {
    const std::string text = refusal(scheme);
    EXPECT_NE(text.find(piece), std::string::npos) << scheme << ": " << text;
  };
  names("bspline:n=-1", "-1");
  names("bspline:n=x", "x");
  names("bspline:n=", "n must be");
  names("bspline:n=2.5", "2.5");
  names("bspline:n=99999999999999999999", "99999999999999999999");
  names("bspline:n=2,arity=1", "arity");
  names("bspline:n=2,arity=65", "65");
  names("mixed:n=0", "0");
  names("dd:l=0", "0");
  names("dd:l=1000", "1000");
  names("interpolating:family=cubic,l=3", "cubic");
  names("interpolating:family=mixed", "l");
  names("interpolating:l=3", "interpolating");
  names("interpolating:family=mixed,l=3,space=\"1,x\"", "interpolating");
  names("interpolating:space=\"1,x,x^2\"", "1, x, x^2");
  names("interpolating:space=\"1,x,exp(t*x)\"", "exp(-t*x)");
  names("interpolating:family=mixed,l=2,arity=1", "arity");
  names("interpolating:space=\"1,x,x^2\",arity=4", "1, x, x^2");
  names("interpolating:family=harmonic,l=128,arity=64", "l=128");
  names("exponential-bspline:space=1,x,foo(x)", "foo(x)");
  names("mask:coefficients=\"1,#\"", "#");
  names("mask:coefficients=\"1,-1\"", "sum 0");
  names("mask:coefficients=\"\"", "coefficients");
  names("mask:coefficients=\"1-w,1,w\"", "centre");
  names("mask:coefficients=\"1/0,1\"", "1/0");
  names("tension4:l=2", "l");
  names("hermite-circle:w=0", "0");
  names("hermite-circle:w=x", "x");
  names("hermite-circle:variant=nice", "nice");
  names("", "empty");
}

TEST(Catalog, DifferentNamesOfOneScheme) {
  const auto same = [](const char* a, const char* b) {
    EXPECT_EQ(symbol(make_scheme(a)), symbol(make_scheme(b))) << a << " " << b;
  };
  same("tension4", "interpolating:family=mixed,l=2");
  same("tension4", "interpolating:space=\"exp(-t*x),1,exp(t*x),x\"");
  same("interpolating:family=harmonic,l=2", "interpolating:family=resonant,l=2");
  same("dd:l=2", "mask:coefficients=\"-1/16,0,9/16,1,9/16,0,-1/16\",lowest=-3");
  same("bspline:n=3", "mask:coefficients=\"1/8,1/2,3/4,1/2,1/8\"");
  same("bspline:n=2", "exponential-bspline:space=1,x,x^2");
  same("mixed:n=1", "exponential-bspline:space=\"cosh(t*x),sinh(t*x),1,x\"");
  same("tension4:arity=3", "interpolating:arity=3,family=harmonic,l=2");
  same("dd:l=2,arity=3", "mask:arity=3,coefficients=\"-4/81,-5/81,0,30/81,60/81,1,60/81,30/81,0,-5/81,-4/81\"");
  same("dd:l=3", "interpolating:space=\"1,x,x^2,x^3,x^4,x^5\"");
  same("mask:coefficients=[1/4,3/4,3/4,1/4]", "bspline:n=2");
}

TEST(Catalog, FamilySpaces) {
  EXPECT_EQ(family_space("mixed", 3).to_string(), Space::parse("1,x,x^2,x^3,exp(t*x),exp(-t*x)").to_string());
  EXPECT_EQ(family_space("harmonic", 2).to_string(),
            Space::parse("1,x,exp(t*x),exp(-t*x),exp(2*t*x),exp(-2*t*x)").to_string());
  EXPECT_EQ(family_space("resonant", 2).to_string(),
            Space::parse("1,x,exp(t*x),exp(-t*x),x*exp(t*x),x*exp(-t*x)").to_string());
  for (const char* family : {"mixed", "harmonic", "resonant"})
    for (unsigned l = 2; l <= 10; ++l)
      EXPECT_EQ(family_space(family, family_member(family, l)).dimension(), 2 * l) << family;
  EXPECT_THROW(family_space("cubic", 2), Error);
}

}  // namespace
}  // namespace twoscale::tests
