// SPDX-License-Identifier: GPL-3.0-or-later
// The figures of romani2009: what is claimed exact is exact, what is not is visibly not, and the page is whole.
#include "twoscale/reports/romani2009.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "twoscale/symbolic/error.hpp"

namespace {

using namespace twoscale;
using namespace twoscale::reports;
using namespace twoscale::reports::romani2009;

// Rounding: 8 levels of sums of 6 (8) terms with weights of size 1.
constexpr double rounding = 1e-12;
constexpr double visible = 1e-3;

TEST(Romani2009, ThereAreTwelveFigures) {
  std::set<std::string> ids;
  int number = 0;
  for (const Figure& f : figures()) {
    EXPECT_EQ(f.number, ++number);
    EXPECT_FALSE(f.panels.empty());
    for (const Panel& p : f.panels) {
      EXPECT_TRUE(ids.insert(p.id).second) << p.id;
      EXPECT_FALSE(p.trials.empty()) << p.id;
    }
  }
  EXPECT_EQ(number, 12);
}

TEST(Romani2009, EveryRunMeetsItsExpectation) {
  for (const Figure& f : figures())
    for (const Panel& p : f.panels)
      for (const Trial& t : p.trials) {
        SCOPED_TRACE(p.id + " " + t.scheme.name + " " + t.v0);
        const Measured m = measure(p, t);
        EXPECT_EQ(m.ran, t.expect != Expect::impossible) << m.refusal;
        if (!m.ran) {
          EXPECT_NE(m.refusal.find(t.v0), std::string::npos) << m.refusal;
          continue;
        }
        EXPECT_GT(m.points, 1000U);
        if (t.expect == Expect::exact) {
          EXPECT_LT(m.deviation, rounding);
        }
        if (t.expect == Expect::different) {
          EXPECT_GT(m.deviation, visible);
        }
        if (t.expect == Expect::shape) {
          EXPECT_GT(m.polygon_distance, visible);
          EXPECT_LT(m.polygon_distance, 1);
          EXPECT_GE(m.turning, 1);
        }
      }
}

// The deviation does not come from the number of levels: a wrong v^0 is seen at once, the right one at no level.
TEST(Romani2009, AWrongParameterIsSeen) {
  for (const Figure& f : figures())
    for (const Panel& p : f.panels) {
      Trial t = p.trials[0];
      if (t.expect != Expect::exact) continue;
      EXPECT_LT(measure(p, t, 1).deviation, rounding) << p.id;
      t.v0 = "(" + t.v0 + ")+1/50";
      // A parabola is in the space of every v^0 of section 4.1 only.
      if (p.id == "3a") continue;
      EXPECT_GT(measure(p, t).deviation, 1e-8) << p.id;
    }
}

std::string bytes(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream out;
  out << file.rdbuf();
  return out.str();
}

// Every element that is opened is closed, in order; <x/> closes itself. Returns the first fault.
std::string first_imbalance(const std::string& html) {
  std::vector<std::string> open;
  for (std::size_t at = html.find('<'); at != std::string::npos; at = html.find('<', at + 1)) {
    if (html.compare(at, 9, "<!DOCTYPE") == 0) continue;
    const std::size_t end = html.find('>', at);
    if (end == std::string::npos) return "no > after " + html.substr(at, 40);
    std::string tag = html.substr(at + 1, end - at - 1);
    const bool closing = tag.front() == '/';
    const std::string name = tag.substr(closing ? 1 : 0, tag.find_first_of(" \n/", 1) - (closing ? 1 : 0));
    if (closing) {
      const std::string closed = tag.substr(1);
      if (open.empty() || open.back() != closed)
        return "</" + closed + "> closes " + (open.empty() ? "nothing" : open.back());
      open.pop_back();
    } else if (tag.back() != '/') {
      open.push_back(name);
    }
    at = end;
  }
  return open.empty() ? "" : open.back() + " is not closed";
}

// The page without the text of its scripts.
std::string without_scripts(const std::string& html) {
  static const std::regex script("<script>[^]*?</script>");
  return std::regex_replace(html, script, "<script></script>");
}

// The page without what stands in src="...".
std::string without_pictures(const std::string& html) {
  std::string s;
  std::size_t from = 0;
  for (std::size_t at = html.find("src=\""); at != std::string::npos; at = html.find("src=\"", from)) {
    s += html.substr(from, at - from);
    EXPECT_EQ(html.compare(at + 5, 26, "data:image/svg+xml;base64,"), 0);
    from = html.find('"', at + 5);
  }
  return s + html.substr(from);
}

class Report : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    root() = std::filesystem::temp_directory_path() / ("twoscale report test " + std::to_string(getpid()));
    PaperOptions options;
    options.checker = [](std::string_view certificate) {
      return reports::CheckerVerdict{certificate.find("fnv1a64") != std::string_view::npos, {"<looked at>"}};
    };
    summary() = write_report((root() / "a" / "b").string(), options);
    page() = bytes(root() / "a" / "b" / "index.html");
  }
  static void TearDownTestSuite() { std::filesystem::remove_all(root()); }

  static std::filesystem::path& root() {
    static std::filesystem::path p;
    return p;
  }
  static PaperSummary& summary() {
    static PaperSummary s;
    return s;
  }
  static std::string& page() {
    static std::string s;
    return s;
  }
};

TEST_F(Report, IsWellFormed) {
  EXPECT_EQ(first_imbalance(without_scripts(page())), "");
  EXPECT_EQ(page().compare(0, 15, "<!DOCTYPE html>"), 0);
  const std::string text = without_scripts(page());
  // No bare & either.
  static const std::regex bare("&(?!(amp|lt|gt|quot|#x[0-9A-Fa-f]+);)");
  for (std::size_t at = text.find('&'); at != std::string::npos; at = text.find('&', at + 1))
    EXPECT_FALSE(std::regex_search(text.substr(at, 12), bare, std::regex_constants::match_continuous))
        << text.substr(at, 40);
}

TEST_F(Report, EveryNameIsUsedOnce) {
  static const std::regex id("[^a-z]id=\"([^\"]*)\"");
  const std::string text = without_scripts(page());
  std::set<std::string> seen;
  for (std::sregex_iterator i(text.begin(), text.end(), id), end; i != end; ++i)
    EXPECT_TRUE(seen.insert((*i)[1]).second) << (*i)[1];
  EXPECT_GT(seen.size(), 60U);
}

TEST_F(Report, ContainsEveryFigureOnce) {
  const auto count = [](const std::string& piece) {
    int n = 0;
    for (std::size_t at = page().find(piece); at != std::string::npos; at = page().find(piece, at + 1)) ++n;
    return n;
  };
  for (const Figure& f : figures()) {
    EXPECT_EQ(count("id=\"figure-" + std::to_string(f.number) + "\""), 1);
    for (const Panel& p : f.panels) {
      EXPECT_EQ(count("id=\"panel-" + p.id + "\""), 1) << p.id;
      EXPECT_GT(bytes(root() / "a" / "b" / "figures" / (p.id + ".svg")).size(), 1000U) << p.id;
      EXPECT_GT(bytes(root() / "a" / "b" / "data" / (p.id + ".csv")).size(), 10U) << p.id;
    }
  }
  const auto pictures = static_cast<int>(summary().figures.size());
  EXPECT_EQ(count("<img "), pictures);
  EXPECT_EQ(count("data:image/svg+xml;base64,"), pictures);
  for (const auto& f : summary().figures)
    EXPECT_TRUE(std::filesystem::is_regular_file(root() / "a" / "b" / f.file)) << f.file;
}

TEST_F(Report, NeedsNothingFromOutside) {
  const std::string text = without_pictures(without_scripts(page()));
  for (const char* piece : {"http:", "https:", "//", "@import", "url(", "<script src", "<link", "<iframe"})
    EXPECT_EQ(text.find(piece), std::string::npos) << piece;
  // Links lead into the page or to files that are there.
  static const std::regex link("href=\"([^\"]*)\"");
  for (std::sregex_iterator i(text.begin(), text.end(), link), end; i != end; ++i) {
    const std::string target = (*i)[1];
    if (target.starts_with("data:application/json;base64,")) continue;
    const bool inside = target[0] == '#' && text.find("id=\"" + target.substr(1) + "\"") != std::string::npos;
    EXPECT_TRUE(inside || std::filesystem::is_regular_file(root() / "a" / "b" / target)) << target;
  }
}

TEST_F(Report, SaysWhatWasMeasured) {
  EXPECT_LT(summary().largest_exact_deviation, rounding);
  EXPECT_GT(summary().exact_runs, 30);
  EXPECT_TRUE(summary().all_certificates_valid);
  EXPECT_NE(page().find("&lt;looked at&gt;"), std::string::npos);
}

TEST_F(Report, IsDeterministic) {
  PaperOptions options;
  options.checker = [](std::string_view certificate) {
    return reports::CheckerVerdict{certificate.find("fnv1a64") != std::string_view::npos, {"<looked at>"}};
  };
  write_report((root() / "again").string(), options);
  EXPECT_EQ(bytes(root() / "again" / "index.html"), page());
  EXPECT_EQ(bytes(root() / "again" / "report.json"), bytes(root() / "a" / "b" / "report.json"));
}

TEST_F(Report, AnUnusableDirectoryIsRefused) {
  std::ofstream(root() / "file") << "x";
  for (const auto& path : {(root() / "file").string(), (root() / "file" / "x").string(), std::string("/proc/none")}) {
    try {
      write_report(path, {});
      ADD_FAILURE() << path;
    } catch (const Error& e) {
      EXPECT_EQ(e.kind, Error::Kind::io) << e.what();
    }
  }
}

}  // namespace
