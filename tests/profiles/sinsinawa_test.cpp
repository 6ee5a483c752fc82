// Real terrain: a river valley with surveyed points, in feet and in metres.

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "profiles/dem.hpp"
#include "tests/verification/record.hpp"

namespace leda::profiles {
namespace {

namespace fs = std::filesystem;

TEST(Sinsinawa, BilinearSamplesAgreeWithTheSurveyedPoints) {
  const fs::path folder = fs::path(LEDA_SHARED_DATA) / "sinsinawa";
  if (!fs::exists(folder)) GTEST_SKIP() << "no " << folder << " beside the source";
  const Dem dem = Dem::open(folder / "sinsinawa_dem_2m_feet.tif",
                            {.vertical_unit = "ft", .epsg = 0, .limits = {}});
  std::ifstream points(folder / "riffle_floodplain_points.csv");
  std::string line, field;
  std::getline(points, line);
  int count = 0;
  double squares = 0;
  while (std::getline(points, line)) {
    std::istringstream fields(line);
    std::vector<std::string> row;
    while (std::getline(fields, field, ',')) row.push_back(field);
    const auto z = dem.sample({std::stod(row.at(1)), std::stod(row.at(2))});
    ASSERT_TRUE(z) << line;
    const double off_feet = *z / 0.3048 - std::stod(row.at(7));
    squares += off_feet * off_feet;
    ++count;
  }
  EXPECT_EQ(count, 3522);
  const double rmse_feet = std::sqrt(squares / count);
  leda::test::record(rmse_feet, " ft over ", count, " points");
  EXPECT_LE(rmse_feet, 0.20);
}

TEST(Sinsinawa, FeetAndMetresAreTheSameGround) {
  const fs::path folder = fs::path(LEDA_SHARED_DATA) / "sinsinawa";
  if (!fs::exists(folder)) GTEST_SKIP() << "no " << folder << " beside the source";
  const Dem feet = Dem::open(folder / "sinsinawa_dem_2m_feet.tif",
                             {.vertical_unit = "ft", .epsg = 0, .limits = {}});
  const Dem metres = Dem::open(folder / "sinsinawa_dem_2m_m.tif");
  int both = 0;
  for (int column = 5; column < 571; column += 7) {
    for (int row = 5; row < 944; row += 7) {
      const MapPoint p = metres.to_map(column, row);
      const auto a = feet.sample(p), b = metres.sample(p);
      EXPECT_EQ(a.has_value(), b.has_value());
      if (!a || !b) continue;
      EXPECT_NEAR(*a, *b, 0.002);
      ++both;
    }
  }
  EXPECT_GT(both, 1000);
}

}  // namespace
}  // namespace leda::profiles
