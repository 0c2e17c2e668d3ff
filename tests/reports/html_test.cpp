// SPDX-License-Identifier: GPL-3.0-or-later
#include "twoscale/reports/html.hpp"

#include <gtest/gtest.h>

#include "twoscale/reports/derivation.hpp"
#include "twoscale/symbolic/catalog.hpp"
#include "twoscale/symbolic/error.hpp"

namespace {

using namespace twoscale;
using namespace twoscale::reports;

TEST(Html, Escapes) { EXPECT_EQ(escaped("a<b>&\"c\x01"), "a&lt;b&gt;&amp;&quot;c "); }

TEST(Html, Base64) {
  const std::string head = "data:image/svg+xml;base64,";
  EXPECT_EQ(data_uri(""), head);
  EXPECT_EQ(data_uri("f"), head + "Zg==");
  EXPECT_EQ(data_uri("fo"), head + "Zm8=");
  EXPECT_EQ(data_uri("foo"), head + "Zm9v");
  EXPECT_EQ(data_uri("foob\xff\xfe"), head + "Zm9vYv/+");
}

TEST(Mathml, Typesets) {
  EXPECT_EQ(mathml("-1/2"), "<mrow><mo>−</mo><mfrac><mrow><mn>1</mn></mrow><mrow><mn>2</mn></mrow></mfrac></mrow>");
  EXPECT_EQ(mathml("v_s^2"),
            "<mrow><msup><mrow><msub><mi>v</mi><mi>s</mi></msub></mrow><mrow><mn>2</mn></mrow></msup></mrow>");
  EXPECT_EQ(mathml("exp(-t*x)"),
            "<mrow><msup><mi>e</mi><mrow><mo>−</mo><mi>t</mi><mo>&#x2062;</mo><mi>x</mi></mrow></msup></mrow>");
  EXPECT_NE(mathml("(a + b)*c").find("<mo stretchy=\"false\">(</mo>"), std::string::npos);
  EXPECT_EQ(mathml("(a + b)/c").find("<mo stretchy=\"false\">(</mo>"), std::string::npos);
  EXPECT_NE(mathml("cos(4*pi/5)").find("π"), std::string::npos);
}

TEST(Mathml, RefusesWhatItCannotRead) {
  for (const char* text : {"", "1+", "(", "f(", "a b", "1)", "*", "a^", "\xff", "<script>"})
    EXPECT_THROW(mathml(text), Error) << text;
  EXPECT_THROW(mathml(std::string(100000, '(')), Error);
}

// Whatever the library prints can be typeset.
TEST(Mathml, ReadsEveryMaskOfTheCatalogue) {
  for (const CatalogEntry& entry : catalog())
    for (const std::string& name : entry.examples) {
      const Scheme s = make_scheme(name);
      for (const Stencil& phase : s.phases)
        for (const auto& block : phase.blocks)
          for (const auto& c : block) EXPECT_NO_THROW(mathml(c.to_string())) << name;
      if (!s.space) continue;
      for (const auto& item : s.space->items()) EXPECT_NO_THROW(mathml(item)) << item;
    }
}

// A derivation on a page has its steps and its values; another space has other values.
TEST(DerivationHtml, HasTheStepsInOrder) {
  const Derivation d = derive(make_scheme("tension4"));
  const std::string html = to_html(d);
  std::size_t at = 0;
  for (const char* step : {"The space", "σ, the approximating scheme", "The linear system H w", "<h3>ω</h3>",
                           "ζ = σω, the 4-point", "Where a step fails"}) {
    const std::size_t found = html.find(step, at);
    ASSERT_NE(found, std::string::npos) << step;
    at = found;
  }
  EXPECT_NE(html.find(mathml(d.interpolating->zeta.coefficient(3).to_string())), std::string::npos);
  EXPECT_NE(html.find("zeta_-3 = zeta_3 = -1/(8*v*(v + 1))"), std::string::npos);
  EXPECT_NE(html, to_html(derive(make_scheme("interpolating:family=mixed,l=3"))));
}

TEST(DerivationHtml, IsWellFormedForTheCatalogue) {
  const auto count = [](const std::string& html, const std::string& piece) {
    int n = 0;
    for (std::size_t at = html.find(piece); at != std::string::npos; at = html.find(piece, at + 1)) ++n;
    return n;
  };
  for (const CatalogEntry& entry : catalog()) {
    const Scheme s = make_scheme(entry.examples[0]);
    if (!s.space || s.block > 1 || !is_uniform(s)) continue;
    const std::string html = to_html(derive(s));
    for (const std::string tag : {"math", "mtable", "mtr", "mtd", "mrow", "li", "ol", "details", "pre", "p", "div"})
      EXPECT_EQ(count(html, "<" + tag + ">") + count(html, "<" + tag + " "), count(html, "</" + tag + ">"))
          << s.id << " " << tag;
  }
}

}  // namespace
