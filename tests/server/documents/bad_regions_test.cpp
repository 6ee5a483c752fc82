// The corpus of bad regions: like bad_cases_test.cpp.
#include <gtest/gtest.h>

#include "server/documents/published_schema.hpp"
#include "server/documents/region_request.hpp"
#include "tests/server/documents/read_data.hpp"
#include "tests/server/documents/region_text.hpp"

namespace leda::server {
namespace {

using nlohmann::json;

enum class Schema { sees_it, cannot };

struct BadRegion {
  const char* name;
  Schema schema;
  const char* change;
  std::multiset<std::string> expected;
};

void PrintTo(const BadRegion& one, std::ostream* out) { *out << one.name; }

const BadRegion corpus[] = {
    {"no_inputs", Schema::sees_it, R"([{"op": "replace", "path": "", "value": {}}])", {"/inputs"}},
    {"inputs_empty",
     Schema::sees_it,
     R"([{"op": "replace", "path": "/inputs", "value": {}}])",
     {"/inputs/name", "/inputs/dem", "/inputs/sections", "/inputs/soil", "/inputs/resolution"}},
    {"unknown_keys",
     Schema::sees_it,
     R"([{"op": "add", "path": "/surprise", "value": {}},
         {"op": "add", "path": "/inputs/soils", "value": {}},
         {"op": "add", "path": "/inputs/screening/skip", "value": true},
         {"op": "add", "path": "/inputs/sections/0/colour", "value": "red"},
         {"op": "add", "path": "/inputs/sections/1/spacing", "value": 1},
         {"op": "add", "path": "/inputs/soil/models/0/wher", "value": []}])",
     {"/surprise", "/inputs/soils", "/inputs/screening/skip", "/inputs/sections/0/colour",
      "/inputs/sections/1/spacing", "/inputs/soil/models/0/wher"}},
    {"sections_empty",
     Schema::sees_it,
     R"([{"op": "replace", "path": "/inputs/sections", "value": []}])",
     {"/inputs/sections"}},
    {"sections_text",
     Schema::sees_it,
     R"([{"op": "replace", "path": "/inputs/sections", "value": "all"}])",
     {"/inputs/sections"}},
    {"line_crosses_itself",
     Schema::cannot,
     R"([{"op": "replace", "path": "/inputs/sections/0/line",
          "value": [[0, 0], [10, 10], [10, 0], [0, 10]]}])",
     {"/inputs/sections/0/line"}},
    {"line_of_one_point",
     Schema::sees_it,
     R"([{"op": "replace", "path": "/inputs/sections/0/line", "value": [[0, 0]]}])",
     {"/inputs/sections/0/line"}},
    {"names_twice_and_unfit",
     Schema::cannot,
     R"([{"op": "replace", "path": "/inputs/sections/2/name", "value": "AA'"},
         {"op": "add", "path": "/inputs/sections/-", "value": {"name": "a/b",
          "line": [[0, 0], [1, 0]]}},
         {"op": "add", "path": "/inputs/sections/-", "value": {"name": "S001",
          "line": [[0, 0], [1, 0]]}}])",
     {"/inputs/sections/2/name", "/inputs/sections/3/name", "/inputs/sections/4/name"}},
    {"along_zero_and_negative",
     Schema::sees_it,
     R"([{"op": "replace", "path": "/inputs/sections/1/spacing_m", "value": 0},
         {"op": "replace", "path": "/inputs/sections/1/upslope_m", "value": -250},
         {"op": "remove", "path": "/inputs/sections/1/downslope_m"}])",
     {"/inputs/sections/1/spacing_m", "/inputs/sections/1/upslope_m",
      "/inputs/sections/1/downslope_m"}},
    {"along_without_length",
     Schema::cannot,
     R"([{"op": "replace", "path": "/inputs/sections/1/upslope_m", "value": 0},
         {"op": "replace", "path": "/inputs/sections/1/downslope_m", "value": 0}])",
     {"/inputs/sections/1"}},
    {"too_many_sections",
     Schema::cannot,
     R"([{"op": "replace", "path": "/inputs/sections/1/spacing_m", "value": 0.01}])",
     {"/inputs/sections"}},
    {"models_empty",
     Schema::sees_it,
     R"([{"op": "replace", "path": "/inputs/soil/models", "value": []}])",
     {"/inputs/soil/models"}},
    {"models_beside_a_model",
     Schema::sees_it,
     R"([{"op": "add", "path": "/inputs/soil/layers", "value": []}])",
     {"/inputs/soil/layers"}},
    {"model_names_and_places",
     Schema::cannot,
     R"([{"op": "replace", "path": "/inputs/soil/models/1/name", "value": "plain"},
         {"op": "remove", "path": "/inputs/soil/models/1/where"}])",
     {"/inputs/soil/models/1/name", "/inputs/soil/models/1"}},
    {"where_empty",
     Schema::sees_it,
     R"([{"op": "replace", "path": "/inputs/soil/models/1/where", "value": []}])",
     {"/inputs/soil/models/1/where"}},
    {"where_crosses",
     Schema::cannot,
     R"([{"op": "replace", "path": "/inputs/soil/models/1/where/0",
          "value": [[0, 0], [4, 4], [4, 0], [0, 4]]}])",
     {"/inputs/soil/models/1/where/0"}},
    {"base_twice",
     Schema::sees_it,
     R"([{"op": "add", "path": "/inputs/soil/models/0/base_m", "value": 0}])",
     {"/inputs/soil/models/0/base_below_toe_m"}},
    {"base_negative_and_water_above_ground",
     Schema::sees_it,
     R"([{"op": "replace", "path": "/inputs/soil/models/0/base_below_toe_m", "value": 0},
         {"op": "replace", "path": "/inputs/soil/models/0/water_table/depth_m", "value": -1}])",
     {"/inputs/soil/models/0/base_below_toe_m", "/inputs/soil/models/0/water_table/depth_m"}},
    {"lines_over_one_section",
     Schema::sees_it,
     R"([{"op": "replace", "path": "/inputs/soil/models/0/layers/0",
          "value": {"material": "crust", "bottom": [[0, 1], [1, 1]]}},
         {"op": "replace", "path": "/inputs/soil/models/0/water_table",
          "value": {"line": [[0, 1], [1, 1]]}}])",
     {"/inputs/soil/models/0/layers/0/bottom", "/inputs/soil/models/0/water_table/line"}},
    {"water_table_empty",
     Schema::sees_it,
     R"([{"op": "replace", "path": "/inputs/soil/models/0/water_table", "value": {}}])",
     {"/inputs/soil/models/0/water_table/depth_m"}},
    {"soil_layers_and_materials",
     Schema::sees_it,
     R"([{"op": "replace", "path": "/inputs/soil/models/0/layers/1/material", "value": "sand"},
         {"op": "replace", "path": "/inputs/soil/models/0/materials/crust/youngs_modulus_kPa",
          "value": 0},
         {"op": "replace", "path": "/inputs/soil/models/0/materials/clay/softening/shape_factor",
          "value": "80"}])",
     {"/inputs/soil/models/0/layers/1/material",
      "/inputs/soil/models/0/materials/crust/youngs_modulus_kPa",
      "/inputs/soil/models/0/materials/clay/softening/shape_factor"}},
    {"excavation",
     Schema::sees_it,
     R"([{"op": "replace", "path": "/inputs/trigger", "value": {"kind": "excavation",
          "polygon": [[0, 0], [1, 0], [1, 1]]}}])",
     {"/inputs/trigger"}},
    {"settings",
     Schema::sees_it,
     R"([{"op": "replace", "path": "/inputs/trigger/then_toe_cut_m", "value": 0},
         {"op": "replace", "path": "/inputs/resolution/cell_m", "value": -1},
         {"op": "replace", "path": "/inputs/damping/dynamic", "value": 1},
         {"op": "replace", "path": "/inputs/stop/max_time_s", "value": 0},
         {"op": "replace", "path": "/inputs/dryRun", "value": "yes"}])",
     {"/inputs/trigger/then_toe_cut_m", "/inputs/resolution/cell_m", "/inputs/damping/dynamic",
      "/inputs/stop/max_time_s", "/inputs/dryRun"}},
};

class BadRegions : public testing::TestWithParam<BadRegion> {};

json changed(const char* change) { return test::region().patch(json::parse(change)); }

TEST_P(BadRegions, EachGivesAllItsFaults) {
  const auto parsed =
      parse_region_request(changed(GetParam().change).dump(), DemNaming::registered_only);
  EXPECT_FALSE(parsed);
  EXPECT_EQ(test::pointers(parsed.faults), GetParam().expected) << test::text(parsed.faults);
}

TEST_P(BadRegions, ReadersAndSchemaAgree) {
  const json document = changed(GetParam().change);
  const auto seen = schema_faults(PublishedSchema::region_request, document);
  EXPECT_EQ(!seen.empty(), GetParam().schema == Schema::sees_it) << test::text(seen);
  const auto faults = parse_region_request(document.dump(), DemNaming::registered_only).faults;
  EXPECT_EQ(test::text(faults).find("published schema"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Corpus, BadRegions, testing::ValuesIn(corpus),
                         [](const auto& one) { return std::string(one.param.name); });

TEST(GoodRegions, MatchTheSchema) {
  for (const json& document : {test::region(), test::small_region()}) {
    EXPECT_EQ(test::text(schema_faults(PublishedSchema::region_request, document)), "");
  }
}

}  // namespace
}  // namespace leda::server
