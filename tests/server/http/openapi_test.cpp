#include "server/http/openapi.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "server/documents/openapi_schema.hpp"
#include "server/http/routes.hpp"
#include "server/jobs/process.hpp"

namespace leda::server {
namespace {

using nlohmann::json;
using Adapter = valijson::adapters::NlohmannJsonAdapter;

/// Faults against the schema that the OpenAPI Initiative publishes for 3.0 documents (2021-09-28,
/// Apache License 2.0), which stands in tests/data.
std::vector<std::string> faults_of(const json& document) {
  std::ifstream file(std::string(LEDA_TEST_DATA) + "/openapi-3.0-schema.json");
  const json rules = json::parse(file);
  valijson::Schema schema;
  valijson::SchemaParser(valijson::SchemaParser::kDraft4).populateSchema(Adapter(rules), schema);
  valijson::Validator validator(valijson::Validator::kStrongTypes);
  valijson::ValidationResults results;
  std::vector<std::string> faults;
  if (validator.validate(schema, Adapter(document), &results)) return faults;
  for (const auto& error : results) {
    std::string place;
    for (const auto& part : error.context) place += part;
    faults.push_back(place + ": " + error.description);
  }
  if (faults.empty()) faults.emplace_back("without a reason");
  return faults;
}

void for_each_reference(const json& part, const std::function<void(const std::string&)>& use) {
  if (part.is_object() && part.contains("$ref")) use(part["$ref"].get<std::string>());
  if (!part.is_structured()) return;
  for (const auto& inner : part) for_each_reference(inner, use);
}

TEST(OpenApi, KeepsTheRulesOfOpenApi30) {
  for (const bool with_tokens : {false, true}) {
    for (const auto& fault : faults_of(openapi_document("http://127.0.0.1:8080", with_tokens))) {
      ADD_FAILURE() << fault;
    }
  }
}

TEST(OpenApi, TheRulesNoticeABreach) {
  json document = openapi_document("http://127.0.0.1:8080", false);
  document["paths"]["/jobs"]["get"].erase("responses");
  EXPECT_FALSE(faults_of(document).empty());
  document = openapi_document("http://127.0.0.1:8080", false);
  document["components"]["schemas"]["positive"]["exclusiveMinimum"] = 0;
  EXPECT_FALSE(faults_of(document).empty());
}

TEST(OpenApi, EveryReferenceResolves) {
  const json document = openapi_document("http://127.0.0.1:8080", true);
  int references = 0;
  for_each_reference(document, [&](const std::string& to) {
    ++references;
    ASSERT_TRUE(to.starts_with("#/"));
    EXPECT_TRUE(document.contains(json::json_pointer(to.substr(1)))) << to;
  });
  EXPECT_GT(references, 100);
}

TEST(OpenApi, EveryRouteIsDescribedOnceAndSaysWhatItAnswers) {
  const json document = openapi_document("http://127.0.0.1:8080", false);
  std::set<std::string> ids;
  for (const auto& [path, operations] : document["paths"].items()) {
    for (const auto& [verb, operation] : operations.items()) {
      EXPECT_TRUE(ids.insert(operation["operationId"].get<std::string>()).second) << path;
      const json& answers = operation["responses"];
      if (answers.contains("204")) continue;  // nothing comes back
      const json& success = answers.contains("201") ? answers["201"] : answers["200"];
      EXPECT_FALSE(success["content"].empty()) << verb << " " << path;
    }
  }
  EXPECT_EQ(ids.size(), routes().size() + processes().size() - 1);
  EXPECT_TRUE(ids.contains("get_jobs_jobID_results"));
  EXPECT_TRUE(document["paths"].contains("/processes/map-region/execution"));
}

TEST(OpenApi, BoundsAndTuplesAreThoseOf30) {
  EXPECT_EQ(to_openapi({{"exclusiveMinimum", 0}, {"const", 1}}),
            (json{{"minimum", 0}, {"exclusiveMinimum", true}, {"enum", {1}}}));
  EXPECT_EQ(
      to_openapi({{"items", {{{"type", "number"}}, {{"$ref", "#/definitions/x"}}}}}),
      (json{{"items", {{"anyOf", {{{"type", "number"}}, {{"$ref", "#/components/schemas/x"}}}}}}}));
}

}  // namespace
}  // namespace leda::server
