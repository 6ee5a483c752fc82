#include "profiles/register_dem.hpp"

#include <gtest/gtest.h>

#include "tests/profiles/drawn_dem.hpp"

namespace leda::profiles {
namespace {

using test::computed;
using test::drawn;
using test::TestFolder;
using test::write_geotiff;

TEST(RegisterDem, TheNewFileSaysTheSame) {
  const TestFolder folder;
  const auto hill = [](MapPoint p) { return 10 + 0.01 * p.x + 0.02 * p.y; };
  auto drawing = computed(600, 530, {1000, 0.8, 0.3, 2000, 0.3, -0.8}, hill);
  drawing.cells[600 * 100 + 50] = std::numeric_limits<float>::quiet_NaN();
  const auto input = write_geotiff(drawing, folder / "in.tif");
  const RegisteredDem registered = register_dem(input, folder / "out.tif");
  const Dem before = Dem::open(input), after = Dem::open(folder / "out.tif");
  for (const auto& [column, row] : {std::pair{10.0, 12.0}, {311.5, 520.25}, {50.5, 100.5}}) {
    const MapPoint p = before.to_map(column, row);
    ASSERT_EQ(before.sample(p).has_value(), after.sample(p).has_value());
    EXPECT_NEAR(before.sample(p).value_or(0), after.sample(p).value_or(0), 1e-6);
  }
  EXPECT_EQ(registered.info.epsg, 2950);
  EXPECT_TRUE(registered.info.rotated);
  EXPECT_EQ(registered.sha256.size(), 64U);
  EXPECT_LT(registered.lowest_m, registered.highest_m);
  EXPECT_NEAR(registered.share_with_data, 1 - 1.0 / (600 * 530), 1e-9);
}

TEST(RegisterDem, SameInputSameBytes) {
  const TestFolder folder;
  const auto input = write_geotiff(drawn({"123", "456"}), folder / "in.tif");
  EXPECT_EQ(register_dem(input, folder / "a.tif").sha256,
            register_dem(input, folder / "b.tif").sha256);
}

TEST(RegisterDem, KeepsTheStatedVerticalUnit) {
  const TestFolder folder;
  const auto input = write_geotiff(drawn({"11", "11"}, 100), folder / "in.tif");
  const RegisteredDem dem =
      register_dem(input, folder / "out.tif", {.vertical_unit = "ft", .epsg = 0, .limits = {}});
  EXPECT_EQ(dem.info.vertical_unit, "ft");
  EXPECT_NEAR(dem.highest_m, 30.48, 1e-4);
  EXPECT_NEAR(Dem::open(folder / "out.tif").sample({1001, 1999}).value(), 30.48, 1e-4);
}

}  // namespace
}  // namespace leda::profiles
