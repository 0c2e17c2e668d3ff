// SPDX-License-Identifier: GPL-3.0-or-later
/// The grammar of scheme names (contract §3): quotes, commas, brackets.
#include <gtest/gtest.h>

#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"

namespace twoscale::tests {
namespace {

using Keys = std::map<std::string, std::string>;

Keys keys(const std::string& text) { return parse_scheme_name(text).keys; }

TEST(SchemeName, Parts) {
  const SchemeName name = parse_scheme_name("interpolating:family=mixed,l=3");
  EXPECT_EQ(name.id, "interpolating");
  EXPECT_EQ(name.keys, (Keys{{"family", "mixed"}, {"l", "3"}}));
  EXPECT_EQ(parse_scheme_name("tension4").id, "tension4");
  EXPECT_TRUE(keys("tension4").empty());
  EXPECT_EQ(parse_scheme_name("  bspline : n=3 ").id, "bspline");
  EXPECT_EQ(keys("  bspline : n=3 "), (Keys{{"n", "3"}}));
}

TEST(SchemeName, APieceWithoutNameBelongsToTheValueBeforeIt) {
  EXPECT_EQ(keys("a:space=1,x,exp(t*x),exp(-t*x),arity=3"),
            (Keys{{"arity", "3"}, {"space", "1,x,exp(t*x),exp(-t*x)"}}));
  EXPECT_EQ(keys("a:space=\"1,x\",l=2"), (Keys{{"l", "2"}, {"space", "1,x"}}));
  EXPECT_EQ(keys("a:lowest=-2,coefficients=1/8,1/2,3/4"), (Keys{{"coefficients", "1/8,1/2,3/4"}, {"lowest", "-2"}}));
}

TEST(SchemeName, BracketsAndQuotesNeverSplit) {
  EXPECT_EQ(keys("a:d=[1,1/2,3],lambda=1/3"), (Keys{{"d", "[1,1/2,3]"}, {"lambda", "1/3"}}));
  EXPECT_EQ(keys("a:f=g(x,y=2),h=1"), (Keys{{"f", "g(x,y=2)"}, {"h", "1"}}));
  EXPECT_EQ(keys("a:space=\"1,b=2\",c=3"), (Keys{{"c", "3"}, {"space", "1,b=2"}}));
  EXPECT_EQ(keys("a:s=\"\""), (Keys{{"s", ""}}));
}

TEST(SchemeName, QuotesMakeNoDifference) {
  for (const auto& [a, b] : {std::pair("x:space=\"1,x,exp(t*x)\",l=2", "x:space=1,x,exp(t*x),l=2"),
                             std::pair("x:n=\"3\"", "x:n=3"), std::pair("x:l=2,space=1,x", "x:space=1,x,l=2")}) {
    EXPECT_EQ(keys(a), keys(b));
    EXPECT_EQ(parse_scheme_name(a).to_string(), parse_scheme_name(b).to_string());
  }
}

TEST(SchemeName, CanonicalSpellingReadsBack) {
  for (const char* text : {"tension4", "bspline:n=3", "a:space=1,x,exp(t*x)", "a:d=[1,2,3],c=(1,2)", "a:s=\"\"",
                           "a:z=1,y=2,x=3,4", "a:s=\" 1, x \""}) {
    const SchemeName name = parse_scheme_name(text);
    const SchemeName again = parse_scheme_name(name.to_string());
    EXPECT_EQ(again.id, name.id) << text;
    EXPECT_EQ(again.keys, name.keys) << text << " -> " << name.to_string();
    EXPECT_EQ(again.to_string(), name.to_string()) << text;
  }
  EXPECT_EQ(parse_scheme_name("a:space=1,x,l=2").to_string(), "a:l=2,space=\"1,x\"");
}

TEST(SchemeName, Errors) {
  const auto offending = [](const char* text) {
    try {
      return "read as " + parse_scheme_name(text).to_string();
    } catch (const Error& e) {
      EXPECT_EQ(e.kind, Error::Kind::bad_input);
      return e.offending;
    }
  };
  EXPECT_EQ(offending("a:n=1,n=2"), "n");
  EXPECT_EQ(offending("a:3"), "3");
  EXPECT_EQ(offending("a:x,n=1"), "x");
  EXPECT_EQ(offending(":n=1"), ":n=1");
  EXPECT_EQ(offending("a:=3"), "=3");
  EXPECT_EQ(offending("a:s=\"1,x"), "\"1,x");  // a quote without its partner
  EXPECT_EQ(offending("a:s=1\"2\""), "1\"2\"");
  for (const char* text : {"a:n=]", "a:n=(", "a:s=\"(\",n=2", "a:s=)(", "a:d=[1,2,n=3"})
    EXPECT_THROW(parse_scheme_name(text), Error) << text;
  EXPECT_THROW(parse_scheme_name(""), Error);
  EXPECT_THROW(parse_scheme_name("   "), Error);
}

}  // namespace
}  // namespace twoscale::tests
