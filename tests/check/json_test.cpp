// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of the checker: the JSON subset and the reader of members.
#include "twoscale/check/json.hpp"

#include <gtest/gtest.h>

namespace {

using namespace twoscale::check;

TEST(Json, CanonicalTextSurvives) {
  const std::string text =
      "{\n \"a\": [\n  1,\n  -20,\n  \"x \\\"y\\\" \\\\\"\n ],\n \"b\": [],\n \"c\": {\n  \"d\": 0\n }\n}\n";
  EXPECT_EQ(canonical_json(parse_json(text)), text);
  EXPECT_EQ(canonical_json(parse_json("  {\"a\":[1 ,-20,\n\"x \\\"y\\\" \\\\\"],\"b\":[ ],\"c\":{\"d\":0}}")), text);
}

TEST(Json, EverythingElseIsRefused) {
  for (const char* text : {"",
                           " ",
                           "{",
                           "}",
                           "[",
                           "]",
                           "{}",
                           "[1",
                           "[1,",
                           "[1,]",
                           "[,1]",
                           "{\"a\"}",
                           "{\"a\":}",
                           "{\"a\":1,}",
                           "{a:1}",
                           "\"",
                           "\"\\\"",
                           "\"\\n\"",
                           "\"\\u0041\"",
                           "\"\\/\"",
                           "\"\n\"",
                           "\"\t\"",
                           "\"\x7f\"",
                           "\"\xc3\xa9\"",
                           "true",
                           "false",
                           "null",
                           "1.0",
                           "1e5",
                           "-0",
                           "01",
                           "+1",
                           "-",
                           "1000001",
                           "99999999999999999999999",
                           "1 2",
                           "[1 2]",
                           "// x\n1",
                           "'a'",
                           "NaN",
                           "[1]]",
                           "\t1"}) {
    EXPECT_THROW(parse_json(text), Malformed) << text;
  }
  EXPECT_THROW(parse_json(std::string("[1\0]", 4)), Malformed);
  EXPECT_THROW(parse_json(std::string("1\0", 2)), Malformed);
  EXPECT_NO_THROW(parse_json("-1000000"));
}

TEST(Json, DepthAndSizeAreLimited) {
  EXPECT_NO_THROW(parse_json(std::string(15, '[') + "1" + std::string(15, ']')));
  EXPECT_THROW(parse_json(std::string(16, '[') + "1" + std::string(16, ']')), Malformed);
  EXPECT_THROW(parse_json(std::string(10'000'000, '[')), Malformed);
  std::string many = "[0";
  for (int i = 0; i < 1'000'001; ++i) many += ",0";
  EXPECT_THROW(parse_json(many + "]"), Malformed);
}

TEST(Json, FieldsInTheirOrderOnly) {
  const Value value = parse_json("{\"a\": 1, \"b\": \"x\"}");
  Fields fields(value, "here");
  EXPECT_EQ(fields.take_integer("a", 0, 2), 1);
  EXPECT_THROW(fields.done(), Malformed);
  EXPECT_EQ(fields.take_string("b"), "x");
  EXPECT_NO_THROW(fields.done());
  EXPECT_THROW(fields.take("c"), Malformed);
  Fields other(value, "here");
  EXPECT_THROW(other.take("b"), Malformed);
  EXPECT_THROW(Fields(parse_json("[1]"), "here"), Malformed);
}

}  // namespace
