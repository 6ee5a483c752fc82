#include "server/jobs/request_pointers.hpp"

#include <gtest/gtest.h>

namespace leda::server {
namespace {

using nlohmann::json;

TEST(RequestPointers, ALineOfTheLayoutIsFoundInAMixedList) {
  const json request = json::parse(R"({"inputs": {"sections": [
      {"name": "A", "line": []}, {"along": []}, {"name": "B", "line": []}, {"along": []}]}})");
  EXPECT_EQ(layout_pointer(request, "/lines/1/line/0"), "/inputs/sections/2/line/0");
  EXPECT_EQ(layout_pointer(request, "/along/1/spacing_m"), "/inputs/sections/3/spacing_m");
  EXPECT_EQ(layout_pointer(request, ""), "/inputs/sections");
  EXPECT_EQ(layout_pointer(request, "/lines/9"), "/inputs/sections");
}

TEST(RequestPointers, OneLineToLaySectionsAlongNeedsNoList) {
  const json request = json::parse(R"({"inputs": {"sections": {"along": []}}})");
  EXPECT_EQ(layout_pointer(request, "/along/0/along/3"), "/inputs/sections/along/3");
}

TEST(RequestPointers, SoilIsOneModelOrSeveral) {
  const json one = json::parse(R"({"inputs": {"soil": {"layers": []}}})");
  const json several = json::parse(R"({"inputs": {"soil": {"models": []}}})");
  EXPECT_EQ(soil_pointer(one, "/0/layers/1/bottom_m"), "/inputs/soil/layers/1/bottom_m");
  EXPECT_EQ(soil_pointer(several, "/2/layers/1"), "/inputs/soil/models/2/layers/1");
}

TEST(RequestPointers, AFaultOfACaseIsFoundWhereTheUserWroteIt) {
  const json request = json::parse(R"({"inputs": {"soil": {"layers": []}}})");
  EXPECT_EQ(case_pointer(request, "/resolution/cell_m", 0), "/inputs/resolution/cell_m");
  EXPECT_EQ(case_pointer(request, "/materials/S1/k0", 0), "/inputs/soil/materials/S1/k0");
  EXPECT_EQ(case_pointer(request, "/ground/3", 0), "/inputs/sections");
}

}  // namespace
}  // namespace leda::server
