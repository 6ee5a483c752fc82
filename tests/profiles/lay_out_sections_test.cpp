#include "profiles/lay_out_sections.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "profiles/map_geometry.hpp"
#include "tests/profiles/drawn_dem.hpp"

namespace leda::profiles {
namespace {

using test::computed;
using test::TestFolder;
using test::write_geotiff;

// A river along y = 500 from west to east in a DEM of 1000 m x 1000 m; the north bank is higher.
double valley(MapPoint p) {
  const double off = p.y - 500;
  return off > 0 ? std::min(20.0, 0.5 * std::max(0.0, off - 5))
                 : std::min(8.0, 0.5 * std::max(0.0, -off - 5));
}

class LayOut : public testing::Test {
 protected:
  Dem open(const std::function<double(MapPoint)>& ground) {
    return Dem::open(
        write_geotiff(computed(500, 500, {0, 2, 0, 1000, 0, -2}, ground), folder_ / "dem.tif"));
  }
  std::vector<Fault> faults(const SectionLayout& layout, const LayoutLimits& limits = {}) {
    const Layout laid = lay_out_sections(layout, open(valley), limits);
    EXPECT_TRUE(laid.faults.empty() || laid.sections.empty());
    return laid.faults;
  }
  TestFolder folder_;
};

const MapLine river{{100, 500}, {900, 500}};

bool names(const std::vector<Fault>& faults, const std::string& pointer, const std::string& part) {
  return std::any_of(faults.begin(), faults.end(), [&](const Fault& f) {
    return f.pointer == pointer && f.message.find(part) != std::string::npos;
  });
}

TEST_F(LayOut, SectionsStandAcrossTheLineUphillSideFirst) {
  const Dem dem = open(valley);
  for (const bool reversed : {false, true}) {
    MapLine line = river;
    if (reversed) std::reverse(line.begin(), line.end());
    const Layout laid = lay_out_sections({{}, {{line, 100, 150, 80}}}, dem);
    ASSERT_TRUE(laid.faults.empty());
    ASSERT_EQ(laid.sections.size(), 8U);
    for (std::size_t i = 0; i < 8; ++i) {
      const LaidSection& s = laid.sections[i];
      EXPECT_EQ(s.name, "S00" + std::to_string(i + 1));
      EXPECT_EQ(s.line, 0);
      EXPECT_NEAR(s.order, 50 + 100 * static_cast<double>(i), 1e-6);
      EXPECT_NEAR(s.trace.front().y, 650, 1e-6);
      EXPECT_NEAR(s.trace.back().y, 420, 1e-6);
      EXPECT_NEAR(s.trace.front().x, s.trace.back().x, 1e-6);
    }
  }
}

TEST_F(LayOut, AJaggedLineIsSmoothed) {
  const Dem dem = open(valley);
  MapLine jagged;
  for (int i = 0; i <= 80; ++i)
    jagged.push_back({100 + 10.0 * i, 500 + ((i % 2) != 0 ? 4.0 : -4.0)});
  const Layout laid = lay_out_sections({{}, {{jagged, 100, 150, 80}}}, dem);
  ASSERT_GE(laid.sections.size(), 8U);
  for (const LaidSection& s : laid.sections) {
    EXPECT_NEAR(std::abs(s.trace.front().x - s.trace.back().x) / 230, 0, 0.06);
  }
}

TEST_F(LayOut, TheUphillSideMayChangeAlongTheLineAndIsCarriedOverFlatGround) {
  const auto ground = [](MapPoint p) {
    if (p.x < 400) return valley(p);
    if (p.x < 600) return 3.0;
    return valley({p.x, 1000 - p.y});
  };
  const Layout laid = lay_out_sections({{}, {{river, 100, 100, 100}}}, open(ground));
  ASSERT_EQ(laid.sections.size(), 8U);
  EXPECT_GT(laid.sections[1].trace.front().y, 500);
  EXPECT_GT(laid.sections[3].trace.front().y, 500);  // flat: as its neighbour
  EXPECT_LT(laid.sections[6].trace.front().y, 500);
}

TEST_F(LayOut, NamedLinesAreTurnedDownhill) {
  const MapLine up{{300, 400}, {300, 650}};
  const Layout laid = lay_out_sections({{{"AA'", up}}, {}}, open(valley));
  ASSERT_EQ(laid.sections.size(), 1U);
  EXPECT_EQ(laid.sections[0].line, -1);
  EXPECT_EQ(laid.sections[0].trace, (MapLine{{300, 650}, {300, 400}}));
}

TEST_F(LayOut, EveryFaultIsNamedAtOnce) {
  const double nan = std::nan("");
  const auto all = faults({{{"A", {{300, 400}, {300, 5000}}},
                            {"A", {{300, 400}, {300, 600}}},
                            {"", {{300, 400}, {300, 600}}},
                            {"loop", {{300, 400}, {400, 400}, {400, 450}, {350, 450}, {350, 300}}},
                            {"nan", {{nan, 400}, {300, 600}}},
                            {"short", {{300, 400}, {300, 405}}},
                            {"one", {{300, 400}}}},
                           {{river, 0, -5, nan}}});
  EXPECT_TRUE(names(all, "/lines/0/line/1", "outside the DEM"));
  EXPECT_TRUE(names(all, "/lines/1/name", "another section"));
  EXPECT_TRUE(names(all, "/lines/2/name", "1 to 100 characters"));
  EXPECT_TRUE(names(all, "/lines/3/line", "crosses itself at (350.00, 400.00)"));
  EXPECT_TRUE(names(all, "/lines/4/line/0", "finite"));
  EXPECT_TRUE(names(all, "/lines/5/line", "at least 20 m"));
  EXPECT_TRUE(names(all, "/lines/6/line", "1 points"));
  EXPECT_TRUE(names(all, "/along/0/spacing_m", "positive"));
  EXPECT_TRUE(names(all, "/along/0/upslope_m", "positive"));
  EXPECT_TRUE(names(all, "/along/0/downslope_m", "positive"));
}

TEST_F(LayOut, APointOutsideIsToldWhatItWasProbablyMeantToBe) {
  const Dem wide = Dem::open(
      write_geotiff(computed(500, 100, {0, 2, 0, 1000, 0, -2}, valley), folder_ / "wide.tif"));
  const auto all =
      lay_out_sections(
          {{{"swapped", {{900, 100}, {950, 150}}}, {"degrees", {{-73, 46}, {-73, 47}}}}, {}}, wide)
          .faults;
  EXPECT_TRUE(names(all, "/lines/0/line/0", "the other way round it lies inside"));
  EXPECT_TRUE(names(all, "/lines/1/line/0", "if these are degrees"));
  EXPECT_FALSE(names(all, "/lines/1/line/0", "the other way round"));
}

TEST_F(LayOut, TooManySectionsAndNoneAtAll) {
  EXPECT_TRUE(names(faults({{}, {{river, 1, 100, 100}}}, {.most_sections = 100}), "",
                    "asks for 800 sections, at most 100"));
  EXPECT_TRUE(names(faults({}), "", "no section"));
  SectionLayout many;
  for (int i = 0; i < 10'000; ++i) many.lines.push_back({std::to_string(i), river});
  EXPECT_TRUE(names(faults(many), "", "asks for 10000 sections"));
}

TEST_F(LayOut, NamesOfLaidSectionsAreTaken) {
  EXPECT_TRUE(names(faults({{{"S003", {{300, 400}, {300, 600}}}}, {{river, 100, 100, 100}}}),
                    "/lines/0/name", "another section"));
}

TEST_F(LayOut, ANamedLineOverMissingDataIsRefusedSayingWhere) {
  const Dem dem = open(
      [](MapPoint p) { return std::hypot(p.x - 300, p.y - 520) < 10 ? std::nan("") : valley(p); });
  const Layout laid = lay_out_sections({{{"A", {{300, 600}, {300, 400}}}}, {}}, dem);
  ASSERT_EQ(laid.faults.size(), 1U);
  EXPECT_EQ(laid.faults[0].pointer, "/lines/0/line");
  EXPECT_NE(laid.faults[0].message.find("from 70.0 m (300.00, 530.00) to 90.0 m (300.00, 510.00)"),
            std::string::npos)
      << laid.faults[0].message;
}

TEST_F(LayOut, CrestAndToeByHandMustLieOnTheLine) {
  NamedLine named{"A", {{300, 650}, {300, 400}}};
  named.crest = MapPoint{500, 550};
  EXPECT_TRUE(names(faults({{named}, {}}), "/lines/0/crest", "200.0 m away"));
  named.crest = MapPoint{302, 550};
  named.toe = MapPoint{300, 550};
  EXPECT_TRUE(names(faults({{named}, {}}), "/lines/0/toe", "lies on the crest"));
}

}  // namespace
}  // namespace leda::profiles
