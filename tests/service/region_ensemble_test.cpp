// An ensemble over a region: from a request to zones of probability, with the real program.

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>

#include "tests/server/temporary_folder.hpp"
#include "tests/service/leda_process.hpp"
#include "tests/service/region_on_a_bank.hpp"

namespace leda::tests {
namespace {

using nlohmann::json;

json uncertain_region() {
  json region = bank_region();
  region["inputs"]["ensemble"] = json::parse(R"({
    "inputs": [
      {"name": "su", "path": "/soil/materials/*/peak_strength_kPa", "apply": "scale",
       "scope": "region", "distribution": {"type": "lognormal", "mean": 1, "cov": 0.4}},
      {"name": "water", "path": "/soil/water_table/depth_m", "scope": "section",
       "distribution": {"type": "triangular", "min": 0, "mode": 1, "max": 4}}],
    "sampling": {"replicates": 4},
    "stop": {"min_members": 16, "max_members": 16, "half_width": 0.01},
    "check": {"members": 2, "seeds": 2}})");
  return region;
}

void post_dem(LedaServer& server, const std::filesystem::path& file) {
  write_bank(file);
  std::ifstream in(file, std::ios::binary);
  const std::string dem{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  const auto raster =
      server.client().Post(std::string("/rasters") + bank_query, dem, "application/octet-stream");
  ASSERT_TRUE(raster);
  ASSERT_EQ(raster->status, 201) << raster->body;
}

/// One job for all the tests of the suite.
class RegionEnsemble : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder = new TemporaryFolder;
    server = new LedaServer(folder->path() / "data", {"--workers", "2"});
    post_dem(*server, folder->path() / "bank.asc");
    const auto answer = execute(uncertain_region());
    ASSERT_EQ(answer->status, 201) << answer->body;
    job = json::parse(answer->body)["jobID"];
    status = server->wait_for_job(job);
  }

  static void TearDownTestSuite() {
    delete server;
    delete folder;
  }

  static httplib::Result execute(const json& region) {
    return server->client().Post("/processes/map-region/execution", region.dump(),
                                 "application/json");
  }

  static std::string of_job(const std::string& path) { return "/jobs/" + job + path; }

  /// Areas of probability zones of a kind and an exceedance, by the square of degrees.
  static double size_of(const json& zones, const std::string& kind, double exceedance) {
    double size = 0;
    for (const auto& feature : zones["features"]) {
      const auto& p = feature["properties"];
      if (p["kind"] != kind || p["exceedance"] != exceedance) continue;
      for (const auto& polygon : feature["geometry"]["coordinates"]) {
        const auto& ring = polygon[0];
        for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
          size += ring[i][0].get<double>() * ring[i + 1][1].get<double>() -
                  ring[i + 1][0].get<double>() * ring[i][1].get<double>();
        }
      }
    }
    return size / 2;
  }

  static inline TemporaryFolder* folder = nullptr;
  static inline LedaServer* server = nullptr;
  static inline std::string job;
  static inline json status;
};

TEST_F(RegionEnsemble, SectionsAreRunAsGivenAndTheirMembersBeside) {
  EXPECT_EQ(status["status"], "successful") << status.dump(2);
  EXPECT_EQ(status["message"], "4 sections: 4 with a result; 72 members: 72 with a result");
  EXPECT_EQ(server->get(of_job("/sections"))["sections"].size(), 4U);
  EXPECT_EQ(server->get("/collections/sections/items?job=" + job)["numberMatched"], 4);
  const json member = server->get(of_job("/sections/AA%27%20member-3"));
  EXPECT_EQ(member["result"]["status"].is_string(), true);
}

TEST_F(RegionEnsemble, ASectionSaysHowSureItIs) {
  const json ensemble = server->get(of_job("/sections/AA%27/ensemble"));
  EXPECT_EQ(ensemble["members"], 16);
  EXPECT_EQ(ensemble["ended_by"], "max-members");
  EXPECT_GT(ensemble["probability_of_sliding"]["value"], 0.1);
  EXPECT_EQ(ensemble["retrogression"]["chance"]["runs"], 4);
  EXPECT_EQ(server->client().Get(of_job("/sections/S001/ensemble?f=svg"))->status, 200);
  EXPECT_EQ(server->client().Get(of_job("/sections/S999/ensemble"))->status, 404);
}

TEST_F(RegionEnsemble, WhatTheRegionSharesIsDrawnOnceForAllSections) {
  const auto csv = server->client().Get(of_job("/members?f=csv"));
  std::map<std::string, std::set<std::string>> strengths, waters;
  std::istringstream lines(csv->body);
  std::string line;
  std::getline(lines, line);
  EXPECT_TRUE(line.starts_with("section,member,kind,weight,su,water,seed")) << line;
  int rows = 0;
  while (std::getline(lines, line)) {
    std::vector<std::string> cells;
    std::istringstream in(line);
    for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
    strengths[cells[1]].insert(cells[4]);
    waters[cells[1]].insert(cells[5]);
    ++rows;
  }
  EXPECT_EQ(rows, 4 * (16 + 2));
  for (const auto& [member, values] : strengths) EXPECT_EQ(values.size(), 1U) << member;
  for (const auto& [member, values] : waters) EXPECT_EQ(values.size(), 4U) << member;
}

TEST_F(RegionEnsemble, ProbabilityZonesAreALayerWhoseZonesAreNested) {
  const json zones = server->get("/collections/probability_zones/items?limit=1000&job=" + job);
  ASSERT_GT(zones["features"].size(), 0U);
  const json& p = zones["features"][0]["properties"];
  EXPECT_EQ(p["members"], 16);
  EXPECT_NE(p["condition"].get<std::string>().find("conditional"), std::string::npos);
  double before = 1e9;
  for (const double exceedance : {0.05, 0.2, 0.5, 0.8, 0.95}) {
    const double size = std::abs(size_of(zones, "release", exceedance));
    EXPECT_LE(size, before * (1 + 1e-9)) << exceedance;
    before = size;
  }
  EXPECT_GT(std::abs(size_of(zones, "release", 0.05)), 0);
  const json release = server->get("/collections/release_zones/items?job=" + job);
  EXPECT_GT(release["features"].size(), 0U) << "of the sections as given";
  for (const auto& zone : release["features"]) {
    EXPECT_FALSE(zone["properties"].contains("exceedance"));
  }
  EXPECT_FALSE(server->get(of_job("/results"))["probability_zones"]["features"].empty());
}

TEST_F(RegionEnsemble, RastersAndExportsAreHandedOut) {
  for (const char* kind : {"release", "runout"}) {
    const auto raster =
        server->client().Get(of_job(std::string("/rasters/") + kind + "_probability.tif"));
    ASSERT_EQ(raster->status, 200) << raster->body;
    EXPECT_EQ(raster->get_header_value("Content-Type"), "image/tiff");
    EXPECT_TRUE(raster->body.starts_with("II*"));
  }
  const auto style = server->client().Get(of_job("/rasters/release_probability.qml"));
  EXPECT_NE(style->body.find("singlebandpseudocolor"), std::string::npos);
  EXPECT_EQ(server->client().Get(of_job("/rasters/hazard.tif"))->status, 404);
  const auto layers = server->client().Get(of_job("/export?f=geojson"));
  EXPECT_NE(layers->body.find("probability_zones"), std::string::npos);
  const auto out = folder->path() / "release_probability.tif";
  const Output exported = run_leda(
      {"export", job, "--data", (folder->path() / "data").string(), "--out", out.string()});
  EXPECT_EQ(exported.exit_code, 0) << exported.errors;
  EXPECT_TRUE(std::filesystem::exists(out));
  const Output unnamed = run_leda({"export", job, "--data", (folder->path() / "data").string(),
                                   "--out", (folder->path() / "hazard.tif").string()});
  EXPECT_NE(unnamed.exit_code, 0);
  EXPECT_NE(unnamed.errors.find("runout_probability.tif"), std::string::npos) << unnamed.errors;
}

TEST_F(RegionEnsemble, TwoSectionsAreComparedByTheirCurves) {
  const json compared = server->get(of_job("/compare?sections=AA%27,BB%27"));
  ASSERT_EQ(compared["ensembles"]["sections"].size(), 2U);
  EXPECT_EQ(compared["ensembles"]["differences"][0]["quantiles"].size(), 5U);
  const auto curves = server->client().Get(of_job("/compare?sections=AA%27,BB%27&f=svg&of=curves"));
  EXPECT_EQ(curves->status, 200);
  EXPECT_TRUE(curves->body.starts_with("<svg"));
  EXPECT_EQ(server->client().Get(of_job("/compare?sections=AA%27,BB%27&of=maps"))->status, 400);
}

TEST_F(RegionEnsemble, AMemberRunAgainAloneGivesTheSame) {
  const json member = server->get(of_job("/sections/S001%20member-5"));
  const auto run = folder->path() / "data" / "runs" / member["run"].get<std::string>();
  const auto alone = folder->path() / "alone";
  const Output again =
      run_leda({"simulate", (run / "case.json").string(), "--out", alone.string()});
  ASSERT_EQ(again.exit_code, 0) << again.errors;
  const auto text = [](const std::filesystem::path& file) {
    std::ifstream in(file);
    return std::string{std::istreambuf_iterator<char>(in), {}};
  };
  EXPECT_EQ(text(alone / "profile_after.csv"), text(run / "profile_after.csv"));
  EXPECT_FALSE(std::filesystem::exists(run / "fields.h5"));
}

TEST_F(RegionEnsemble, EveryFaultIsToldBeforeAnythingIsStored) {
  const auto faulty = [](const char* pointer, const json& value) {
    json region = uncertain_region();
    region[json::json_pointer(pointer)] = value;
    const auto answer = execute(region);
    EXPECT_EQ(answer->status, 400) << answer->body;
    return answer->body;
  };
  const std::string at = "/inputs/ensemble";
  EXPECT_NE(faulty("/inputs/ensemble/inputs/0/path", "/soil/materials/sand/k0").find(at),
            std::string::npos);
  EXPECT_NE(faulty("/inputs/ensemble/inputs/0/path", "/soil/layers/*/bottom_m").find(at),
            std::string::npos);
  EXPECT_NE(faulty("/inputs/ensemble/inputs/0/path", "/sections/0/line/0/0").find("no sections"),
            std::string::npos);
  EXPECT_NE(faulty("/inputs/ensemble/inputs/1/distribution",
                   {{"type", "uniform"}, {"min", -3}, {"max", 1}})
                .find("/inputs/ensemble/inputs/1/distribution"),
            std::string::npos)
      << "a water table above ground";
  EXPECT_NE(faulty("/inputs/ensemble/inputs/0/distribution",
                   {{"type", "discrete"}, {"values", {1, 2}}, {"weights", {0.5, 0.6}}})
                .find("weights"),
            std::string::npos);
  EXPECT_NE(faulty("/inputs/ensemble/stop/max_members", 1'000'000).find("max_members"),
            std::string::npos);
  EXPECT_NE(
      faulty("/inputs/ensemble/rank_correlations", {{{"between", {"su", "water"}}, {"rho", 1.5}}})
          .find("rank_correlations"),
      std::string::npos);
  EXPECT_NE(faulty("/inputs/sections/1/name", "AA' member-3").find("a member of"),
            std::string::npos);
  EXPECT_EQ(server->get("/jobs")["jobs"].size(), 1U);
}

TEST_F(RegionEnsemble, ADryRunTellsTheLeastAndTheMost) {
  json region = uncertain_region();
  region["dryRun"] = true;
  region["inputs"]["ensemble"]["stop"]["max_members"] = 64;
  const auto answer = execute(region);
  ASSERT_EQ(answer->status, 200) << answer->body;
  const json dry = json::parse(answer->body);
  EXPECT_EQ(dry["sections"].size(), 4U);
  EXPECT_EQ(dry["estimate"]["runs"], 4 + 4 * (64 + 2));
  EXPECT_LT(dry["estimate"]["core_hours_at_least"], dry["estimate"]["core_hours"]);
}

}  // namespace
}  // namespace leda::tests
