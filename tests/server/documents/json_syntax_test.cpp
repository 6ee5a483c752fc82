#include "server/documents/json_syntax.hpp"

#include <gtest/gtest.h>

#include "tests/server/documents/read_data.hpp"

namespace leda::server {
namespace {

std::multiset<std::string> faults_of(const std::string& text) {
  return test::pointers(parse_json(text).faults);
}

using Pointers = std::multiset<std::string>;

TEST(ParseJson, GivesTheValue) {
  const auto parsed = parse_json(R"({"a": [1, 2.5, {"b": null}]})");
  ASSERT_TRUE(parsed);
  EXPECT_EQ(*parsed.value, nlohmann::json::parse(R"({"a": [1, 2.5, {"b": null}]})"));
}

TEST(ParseJson, RefusesBrokenTexts) {
  for (const char* text : {"", " \n", "{", "{\"a\": NaN}", "{\"a\": 1} x", "[1,]", "{'a': 1}",
                           "{\"a\": \"\xff\"}", "nul", "\xef\xbb\xbf"}) {
    const auto parsed = parse_json(text);
    EXPECT_FALSE(parsed) << text;
    EXPECT_EQ(parsed.faults.size(), 1U) << text;
  }
}

TEST(ParseJson, SaysWhereTheSyntaxBreaks) {
  const auto parsed = parse_json("{\"a\": 1,\n \"b\" 2}");
  ASSERT_EQ(parsed.faults.size(), 1U);
  EXPECT_NE(parsed.faults[0].message.find("line 2"), std::string::npos) << parsed.faults[0].message;
}

TEST(ParseJson, KnowsUtf16WhenItSeesIt) {
  const std::string little("\xff\xfe{\0}\0", 6);
  const auto parsed = parse_json(little);
  ASSERT_EQ(parsed.faults.size(), 1U);
  EXPECT_NE(parsed.faults[0].message.find("save it as UTF-8"), std::string::npos);
}

TEST(ParseJson, NamesEveryKeyThatOccursTwice) {
  EXPECT_EQ(faults_of(R"({"a": 1, "b": [{}, {"c/d": 1, "c/d": 2}], "a": 3})"),
            (Pointers{"/a", "/b/1/c~1d"}));
}

TEST(ParseJson, NamesANumberTooLargeForADouble) {
  EXPECT_EQ(faults_of(R"({"a": [0, 1e999]})"), Pointers{"/a/1"});
}

TEST(ParseJson, RefusesNestingBombs) {
  EXPECT_TRUE(parse_json(std::string(32, '[') + std::string(32, ']')));
  EXPECT_FALSE(parse_json(std::string(33, '[') + std::string(33, ']')));
  EXPECT_FALSE(parse_json(std::string(5'000'000, '[')));
}

}  // namespace
}  // namespace leda::server
