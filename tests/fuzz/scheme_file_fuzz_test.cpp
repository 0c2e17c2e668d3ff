// SPDX-License-Identifier: GPL-3.0-or-later
/// Scheme files, mutated: the only way out is a scheme, or an Error that names the file, soon.
#include <gtest/gtest.h>

#include <chrono>

#include "support/mutate.hpp"
#include "twoscale/symbolic/error.hpp"
#include "twoscale/symbolic/scheme_file.hpp"

namespace twoscale::tests {
namespace {

const std::vector<std::string>& texts() {
  static const std::vector<std::string> list = [] {
    std::vector<std::string> all{
        scheme_file_template("template"),
        "[scheme]\nname=\"g\"\nsymbol=\"(1+z)^2*(1+g*z+z^2)/"
        "(4+2*g)\"\n[parameters.g]\nscope=\"level\"\nrelation=\"g^2-2\"\n"
        "default=\"sqrt(2)\"\n[[claim]]\nclaim=\"generates\"\nsubject=\"1,x,exp(t*x),exp(-t*x)\"\n",
        "symbol=\"(1+z)^3*(1-w+(2*w+2)*z+(1-w)*z^2)/16\"\n[scheme]\nname=\"r\"\nshift=\"1/"
        "2\"\n[parameters.w]\nscope=\"level\"\n"
        "relation=\"w^3+w\"\ndomain=\"[-1/2,2)\"\n",
        "[scheme]\nname=\"h\"\nblock=2\narity=2\n[parameters.d]\nscope=\"local\"\noffsets=[-1,0]\n[[phase]]\nresidue="
        "0\n"
        "stencil={\"0\"=[[1,0],[0,\"1/2\"]]}\n[[phase]]\nresidue=1\nstencil={\"-1\"=[[\"d_0\",\"d_m1\"],[\"-3/"
        "4\",0]]}\n"};
    for (const auto& [name, text] : embedded_scheme_files()) all.push_back(text);
    return all;
  }();
  return list;
}

void survives(const std::string& text, size_t& read) {
  const auto start = std::chrono::steady_clock::now();
  try {
    const Scheme s = SchemeFile::parse(text, "fuzz.toml").scheme();
    EXPECT_EQ(s.phases.size(), static_cast<size_t>(s.arity));
    ++read;
  } catch (const Error& e) {
    EXPECT_EQ(std::string(e.what()).rfind("fuzz.toml:", 0), 0U) << e.what() << "\nof\n" << text;
    EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos) << e.what();
  } catch (const std::exception& e) {
    ADD_FAILURE() << e.what() << "\nof\n" << text;
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  EXPECT_LT(seconds.count(), 20) << text;
}

TEST(SchemeFileFuzz, Mutations) {
  std::mt19937_64 random(31);
  size_t read = 0;
  for (size_t i = 0; i < rounds(250); ++i)
    for (const auto& text : texts())
      survives(mutate(text, random, "0123456789-+*/^()[]{}\"'=,.:# \nzwgbx_\\\xc3\xff"), read);
  EXPECT_GT(read, 100U);  // or the mutations test nothing
}

TEST(SchemeFileFuzz, RandomBytesAndNesting) {
  std::mt19937_64 random(37);
  size_t read = 0;
  for (size_t i = 0; i < rounds(1500); ++i) {
    std::string text(below(random, 80), ' ');
    for (char& c : text) c = static_cast<char>(below(random, 256));
    survives(text, read);
  }
  for (const char* open : {"[", "{a=", "a=[", "[[", "\"", "'''", "a.", "("}) {
    std::string text;
    for (int i = 0; i < 5000; ++i) text += open;
    survives(text, read);
    survives("[scheme]\nname=\"a\"\nsymbol=" + text, read);
    survives("[scheme]\nname=\"a\"\nsymbol=\"" + text + "\"", read);
  }
}

}  // namespace
}  // namespace twoscale::tests
