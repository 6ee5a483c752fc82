#include "server/documents/compare_document.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "tests/server/documents/some_result.hpp"

namespace leda::server {
namespace {

using nlohmann::json;

std::vector<ComparedSection> two_sections() {
  const SectionResult a = test::some_result();
  SectionResult b = a;
  b.crest_to_crest_retrogression_m = 90;
  b.runout_m = 60.4;
  b.slides = 4;
  const Polyline ground{{0, 21.7}, {183, 21.7}, {220, 5}, {224, 5}, {249, 17}, {306, 17}};
  return {{"AA'", "finished", ground, a.crest, a.toe, a, nullptr},
          {"B <&> \"B\"", "finished", ground, a.crest, a.toe, b, nullptr}};
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

TEST(CompareJson, GivesTheNumbersAndTheirDifferences) {
  const json out = compare_json(two_sections());
  ASSERT_EQ(out["sections"].size(), 2U);
  EXPECT_EQ(out["sections"][0]["name"], "AA'");
  EXPECT_EQ(out["sections"][0]["profile_before_m"].size(), 6U);
  EXPECT_EQ(out["sections"][0]["profile_after_m"].size(), 10U);
  EXPECT_EQ(out["sections"][1]["result"]["runout_m"], 60.4);
  ASSERT_EQ(out["differences"].size(), 1U);
  const json& d = out["differences"][0];
  EXPECT_NEAR(d["crest_to_crest_retrogression_m"].get<double>(), -13.2, 1e-9);
  EXPECT_NEAR(d["runout_m"].get<double>(), 8, 1e-9);
  EXPECT_EQ(d["slides"], -2);
  EXPECT_EQ(d["bank_height_m"], 0);
}

TEST(CompareJson, SectionsWithoutAUsableResultHaveNoDifference) {
  auto sections = two_sections();
  sections[1].result.reset();
  sections.push_back(two_sections()[0]);
  sections[2].result->status = RunStatus::unstable;
  const json out = compare_json(sections);
  EXPECT_TRUE(out["sections"][1]["result"].is_null());
  for (const json& d : out["differences"]) {
    EXPECT_TRUE(d["runout_m"].is_null());
    EXPECT_EQ(d["unknown"]["runout_m"], d["to"].get<std::string>() + " has no usable result");
    EXPECT_EQ(d["bank_height_m"], 0);
  }
}

TEST(CompareJson, ALowerBoundHasNoDifferenceAndSaysWhy) {
  auto sections = two_sections();
  sections[0].result->runout_is = Bound::lower_bound;
  const json d = compare_json(sections)["differences"][0];
  EXPECT_TRUE(d["runout_m"].is_null());
  EXPECT_TRUE(d["runout_from_crest_m"].is_null());
  const std::string why = "that of AA' is a lower bound";
  EXPECT_EQ(d["unknown"], (json{{"runout_m", why}, {"runout_from_crest_m", why}}));
  EXPECT_NEAR(d["crest_to_crest_retrogression_m"].get<double>(), -13.2, 1e-9);
}

TEST(CompareSvg, ShowsBothSectionsWithTheirMarks) {
  const std::string svg = compare_svg(two_sections());
  EXPECT_TRUE(svg.starts_with("<svg "));
  EXPECT_TRUE(svg.ends_with("</svg>\n"));
  EXPECT_EQ(count(svg, "<path "), 4U);
  for (const char* name : {">crest<", ">toe<", ">backscarp<", ">front<"}) {
    EXPECT_EQ(count(svg, name), 2U) << name;
  }
  EXPECT_EQ(count(svg, "elevation (m)"), 2U);
  EXPECT_NE(svg.find("retrogression 103.2 m, runout 52.4 m"), std::string::npos);
  EXPECT_EQ(svg.find(">-0<"), std::string::npos);
}

TEST(CompareSvg, EscapesNames) {
  const std::string svg = compare_svg(two_sections());
  EXPECT_NE(svg.find("B &lt;&amp;&gt; &quot;B&quot;"), std::string::npos);
  EXPECT_EQ(svg.find("<&>"), std::string::npos);
}

TEST(CompareSvg, DrawsLengthsAndHeightsAtOneScale) {
  const std::string svg = compare_svg(two_sections());
  // The drawing's 306 m take 1112 units: crest and toe stand 37 m and 16.7 m apart.
  const auto circle = [&](std::size_t n) {
    std::size_t at = std::string::npos;
    for (std::size_t i = 0; i <= n; ++i) at = svg.find("<circle", at + 1);
    const auto number_after = [&](const char* text) {
      return std::stod(svg.substr(svg.find(text, at) + std::strlen(text)));
    };
    return std::pair(number_after("cx=\""), number_after("cy=\""));
  };
  const auto crest = circle(0), toe = circle(1);
  EXPECT_NEAR(toe.first - crest.first, 37 * 1112.0 / 306, 0.2);
  EXPECT_NEAR(toe.second - crest.second, 16.7 * 1112.0 / 306, 0.2);
}

TEST(CompareSvg, HoldsNoNumberThatIsNotFinite) {
  auto sections = two_sections();
  sections[0].result->front = {NAN, INFINITY};
  sections[1].result->profile_after[3].z = NAN;
  const std::string svg = compare_svg(sections);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
}

}  // namespace
}  // namespace leda::server
