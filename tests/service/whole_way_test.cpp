// From a DEM and a request over HTTP to zones on a map, with the real program and real workers.

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "tests/server/temporary_folder.hpp"
#include "tests/service/leda_process.hpp"
#include "tests/service/region_on_a_bank.hpp"

namespace leda::tests {
namespace {

using nlohmann::json;

/// One job for all the tests of the suite.
class WholeWay : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder = new TemporaryFolder;
    write_bank(folder->path() / "bank.asc");
    server = new LedaServer(folder->path() / "data", {"--workers", "2"});
    std::ifstream file(folder->path() / "bank.asc", std::ios::binary);
    const std::string dem{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    const auto raster = server->client().Post(std::string("/rasters") + bank_query, dem,
                                              "application/octet-stream");
    ASSERT_TRUE(raster);
    ASSERT_EQ(raster->status, 201) << raster->body;
    const auto answer = server->client().Post("/processes/map-region/execution",
                                              bank_region().dump(), "application/json");
    ASSERT_TRUE(answer);
    ASSERT_EQ(answer->status, 201) << answer->body;
    job = json::parse(answer->body)["jobID"];
    status = server->wait_for_job(job);
  }

  static void TearDownTestSuite() {
    delete server;
    delete folder;
  }

  static std::string of_job(const std::string& path) { return "/jobs/" + job + path; }

  static inline TemporaryFolder* folder = nullptr;
  static inline LedaServer* server = nullptr;
  static inline std::string job;
  static inline json status;
};

TEST_F(WholeWay, TheJobSucceeds) {
  EXPECT_EQ(status["status"], "successful") << status.dump(2);
  EXPECT_EQ(status["progress"], 100);
  EXPECT_EQ(status["message"], "4 sections: 4 with a result");
  for (const char* key : {"created", "started", "finished", "updated"}) {
    EXPECT_TRUE(status.contains(key)) << key;
  }
}

TEST_F(WholeWay, EverySectionMovedAndSaysWhatItCost) {
  const json sections = server->get(of_job("/sections"))["sections"];
  ASSERT_EQ(sections.size(), 4U);
  for (const auto& section : sections) {
    EXPECT_EQ(section["status"], "at-rest") << section.dump(2);
    EXPECT_GT(section["crest_to_crest_retrogression_m"], 4.0) << section.dump(2);
    EXPECT_GT(section["runout_m"], 2.0);
    EXPECT_GT(section["run_time_s"], 0.0);
    EXPECT_EQ(section["attempts"], 1);
  }
}

TEST_F(WholeWay, ASectionIsFoundByItsName) {
  const json section = server->get(of_job("/sections/AA%27"));
  EXPECT_EQ(section["name"], "AA'");
  EXPECT_GT(section["profile_before"].size(), 3U);
  EXPECT_GT(section["profile_after"].size(), 10U);
  EXPECT_NEAR(section["crest_m"][1].get<double>(), 20, 0.2);
  EXPECT_NEAR(section["toe_m"][1].get<double>(), 8, 0.2);
  EXPECT_EQ(section["result"]["status"], "at-rest");
  EXPECT_FALSE(section["log"].get<std::string>().empty());
}

TEST_F(WholeWay, EverythingSaysWhichProgramMadeIt) {
  const std::string version = run_leda({"--version"}).text.substr(std::string("leda ").size());
  const std::string known = version.substr(0, version.find('\n'));
  EXPECT_EQ(server->get("/api")["info"]["version"], known);
  EXPECT_EQ(server->get("/processes/map-region")["version"], known);
  const json section = server->get(of_job("/sections/AA%27"));
  EXPECT_EQ(section["version"], known);
  EXPECT_EQ(section["result"]["version"], known);
  EXPECT_EQ(section["engine"], section["result"]["engine"]);
  EXPECT_EQ(section["engine"]["precision"], "single");
  EXPECT_EQ(section["engine"]["time_step_factor"], 0.65);
  const json zones = server->get("/collections/release_zones/items?job=" + job);
  EXPECT_EQ(zones["features"][0]["properties"]["version"], known);
}

TEST_F(WholeWay, SectionsOfTheSameBankAgree) {
  const json comparison = server->get(of_job("/compare?sections=AA%27,BB%27"));
  ASSERT_EQ(comparison["sections"].size(), 2U);
  const auto retrogression_m = [&](int section) {
    return comparison["sections"][section]["result"]["crest_to_crest_retrogression_m"]
        .get<double>();
  };
  EXPECT_NEAR(retrogression_m(1), retrogression_m(0), 6);
  // Both reach the edge of the model: bounds have no difference.
  const json& difference = comparison["differences"][0];
  EXPECT_TRUE(difference["crest_to_crest_retrogression_m"].is_null()) << difference;
  EXPECT_NE(difference["unknown"].dump().find("is a lower bound"), std::string::npos) << difference;
  const auto drawing = server->client().Get(of_job("/compare?sections=AA%27,BB%27&f=svg"));
  ASSERT_TRUE(drawing);
  EXPECT_EQ(drawing->get_header_value("Content-Type"), "image/svg+xml");
  EXPECT_NE(drawing->body.find("<svg"), std::string::npos);
  EXPECT_EQ(server->client().Get(of_job("/compare?sections=AA%27"))->status, 400);
  EXPECT_EQ(server->client().Get(of_job("/compare?sections=AA%27,ZZ"))->status, 404);
}

TEST_F(WholeWay, NeighboursAreJoinedToZones) {
  const json results = server->get(of_job("/results"));
  EXPECT_EQ(results["sections"].size(), 4U);
  EXPECT_EQ(results["release_zones"]["features"].size(), 3U);
  EXPECT_EQ(results["runout_zones"]["features"].size(), 3U);
  bool joined = false;
  for (const auto& zone : results["release_zones"]["features"]) {
    joined = joined || zone["properties"]["sections"] == "S001; S002";
    EXPECT_GT(zone["properties"]["largest_distance_m"], 4.0);
  }
  EXPECT_TRUE(joined) << results["release_zones"].dump(2);
}

TEST_F(WholeWay, ResultsThatAreKnownAreNotSentAgain) {
  const auto first = server->client().Get(of_job("/results"));
  const auto tag = first->get_header_value("ETag");
  ASSERT_FALSE(tag.empty());
  const auto second = server->client().Get(of_job("/results"), {{"If-None-Match", tag}});
  EXPECT_EQ(second->status, 304);
  EXPECT_TRUE(second->body.empty());
}

TEST_F(WholeWay, ZonesAreServedAsFeaturesInLongitudeAndLatitude) {
  const json items = server->get("/collections/release_zones/items?job=" + job + "&limit=2");
  EXPECT_EQ(items["numberMatched"], 3);
  EXPECT_EQ(items["numberReturned"], 2);
  EXPECT_EQ(items["links"][1]["rel"], "next");
  const json& geometry = items["features"][0]["geometry"];
  EXPECT_EQ(geometry["type"], "MultiPolygon");
  EXPECT_NEAR(geometry["coordinates"][0][0][0][0].get<double>(), -72.5, 0.2);
  EXPECT_NEAR(geometry["coordinates"][0][0][0][1].get<double>(), 46.15, 0.1);
  EXPECT_EQ(server->get("/collections/sections/items")["numberMatched"], 4);
  EXPECT_EQ(server->get("/collections/sections/items?bbox=0,0,1,1")["numberMatched"], 0);
  EXPECT_EQ(server->get("/collections/sections")["storageCrs"],
            "http://www.opengis.net/def/crs/EPSG/0/2950");
}

TEST_F(WholeWay, ZonesAreExported) {
  const auto package = server->client().Get(of_job("/export?f=gpkg"));
  ASSERT_TRUE(package);
  EXPECT_EQ(package->status, 200) << package->body;
  EXPECT_EQ(package->body.substr(0, 15), "SQLite format 3");
  const json collection = json::parse(server->client().Get(of_job("/export?f=geojson"))->body);
  EXPECT_EQ(collection["type"], "FeatureCollection");
  EXPECT_EQ(server->client().Get(of_job("/export?f=shp"))->body.substr(0, 2), "PK");
  EXPECT_EQ(server->client().Get(of_job("/export?f=pdf"))->status, 400);
}

TEST_F(WholeWay, TheDemHasAPicture) {
  const auto picture = server->client().Get("/rasters/bank/hillshade.png");
  ASSERT_TRUE(picture);
  EXPECT_EQ(picture->status, 200) << picture->body;
  EXPECT_EQ(picture->body.substr(1, 3), "PNG");
}

TEST_F(WholeWay, NothingFailedSoNothingIsRetried) {
  EXPECT_EQ(server->client().Post(of_job("/retry"))->status, 409);
}

}  // namespace
}  // namespace leda::tests
