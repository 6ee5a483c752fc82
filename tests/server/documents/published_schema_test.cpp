#include "server/documents/published_schema.hpp"

#include <gtest/gtest.h>

#include "tests/server/documents/read_data.hpp"
#include "tests/server/documents/region_text.hpp"

namespace leda::server {
namespace {

using nlohmann::json;

TEST(PublishedSchema, EveryReferenceIsDefined) {
  for (const auto which : {PublishedSchema::case_file, PublishedSchema::hindcast_request,
                           PublishedSchema::region_request, PublishedSchema::simulate_request,
                           PublishedSchema::study_request}) {
    const json& schema = published_schema(which);
    const json flat = schema.flatten();
    for (const auto& [pointer, value] : flat.items()) {
      if (!pointer.ends_with("/$ref")) continue;
      const std::string to = value.get<std::string>();
      ASSERT_TRUE(to.starts_with("#/")) << to;
      EXPECT_TRUE(schema.contains(json::json_pointer(to.substr(1)))) << pointer << " " << to;
    }
  }
}

TEST(PublishedSchema, FaultsPointToTheInnermostPlace) {
  json region = test::region();
  region["inputs"]["soil"]["models"][1]["layers"][0]["a/\"b"] = 1;
  const auto faults = schema_faults(PublishedSchema::region_request, region, "/at");
  bool found = false;
  for (const Fault& f : faults) {
    EXPECT_TRUE(f.pointer.starts_with("/at/inputs/soil")) << f.pointer;
    found = found || f.pointer == "/at/inputs/soil/models/1/layers/0";
  }
  EXPECT_TRUE(found) << test::text(faults);
}

TEST(PublishedSchema, SimulateRequestHoldsTheCase) {
  const json small = json::parse(test::read_case("small-bank.json"));
  EXPECT_TRUE(
      schema_faults(PublishedSchema::simulate_request, {{"inputs", {{"case", small}}}}).empty());
  EXPECT_FALSE(schema_faults(PublishedSchema::simulate_request, {{"inputs", small}}).empty());
}

}  // namespace
}  // namespace leda::server
