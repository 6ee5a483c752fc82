// The demo's DEM carries the section the thesis gives in numbers, wherever it is cut.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "profiles/lay_out_sections.hpp"
#include "profiles/trace_profile.hpp"
#include "tests/profiles/drawn_dem.hpp"

namespace leda::profiles {
namespace {

TEST(DemoDem, EverySectionShowsTheBankOfTheThesis) {
  const test::TestFolder folder;
  const std::string command =
      std::string("'") + LEDA_WRITE_DEMO_DEM + "' '" + (folder / "demo.tif").string() + "'";
  ASSERT_EQ(std::system(command.c_str()), 0);
  const Dem dem = Dem::open(folder / "demo.tif");
  EXPECT_EQ(dem.info().epsg, 2950);
  const NamedLine aa{"AA'", {{380456.24, 5113493.38}, {380515.67, 5113193.20}}};
  const SectionsAlong brook{{{380330.00, 5113200.00},
                             {380395.50, 5113239.34},
                             {380465.10, 5113267.39},
                             {380539.53, 5113282.18},
                             {380615.53, 5113292.66},
                             {380688.54, 5113311.34},
                             {380756.48, 5113343.97}},
                            50,
                            222,
                            84};
  const Layout laid = lay_out_sections({{aa}, {brook}}, dem);
  ASSERT_TRUE(laid.faults.empty()) << laid.faults[0].pointer << " " << laid.faults[0].message;
  EXPECT_EQ(laid.sections.size(), 10U);
  for (const LaidSection& section : laid.sections) {
    const auto cut = trace_profile(section, dem);
    ASSERT_TRUE(std::holds_alternative<Profile>(cut)) << section.name;
    const auto& profile = std::get<Profile>(cut);
    EXPECT_NEAR(profile.bank.crest.z, 21.7, 0.3) << section.name;
    EXPECT_NEAR(profile.bank.toe.z, 5.0, 0.3) << section.name;
    EXPECT_NEAR(profile.bank.toe.x - profile.bank.crest.x, 37, 1.5) << section.name;
    EXPECT_NEAR(profile.bank.crest.x, 183, section.line < 0 ? 1.0 : 8.0) << section.name;
    EXPECT_NEAR(profile.ground.back().z, 17, 0.1) << section.name;
  }
}

}  // namespace
}  // namespace leda::profiles
