// What clients and operators do with a running server: GDAL, formats, logs, backup, dry run.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>

#include "tests/server/temporary_folder.hpp"
#include "tests/service/leda_process.hpp"
#include "tests/service/region_on_a_bank.hpp"

namespace leda::tests {
namespace {

using nlohmann::json;

std::string read_text(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// What a program of this machine prints; nothing where it is not installed.
std::optional<std::string> output_of(std::vector<std::string> arguments,
                                     const std::filesystem::path& out) {
  std::vector<char*> argv;
  argv.reserve(arguments.size() + 1);
  for (auto& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    dup2(open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644), STDOUT_FILENO);
    execvp(argv[0], argv.data());
    _exit(127);
  }
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 127) return std::nullopt;
  return read_text(out);
}

/// One region for all the tests of the suite.
class Clients : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder = new TemporaryFolder;
    write_bank(folder->path() / "bank.asc");
    server = new LedaServer(folder->path() / "data", {"--workers", "2"});
    const auto raster =
        server->client().Post(std::string("/rasters") + bank_query,
                              read_text(folder->path() / "bank.asc"), "application/octet-stream");
    ASSERT_EQ(raster->status, 201) << raster->body;
    job = submit(bank_region());
    ASSERT_EQ(server->wait_for_job(job)["status"], "successful");
  }
  static void TearDownTestSuite() {
    delete server;
    delete folder;
  }

  static std::string submit(const json& request) {
    const auto answer = server->client().Post("/processes/map-region/execution", request.dump(),
                                              "application/json");
    EXPECT_EQ(answer->status, 201) << answer->body;
    return json::parse(answer->body)["jobID"];
  }

  static inline TemporaryFolder* folder = nullptr;
  static inline LedaServer* server = nullptr;
  static inline std::string job;
};

TEST_F(Clients, GdalListsAndReadsTheLayers) {
  const std::string source = "OAPIF:" + server->url();
  const auto layers = output_of({"ogrinfo", "-ro", source}, folder->path() / "layers.txt");
  if (!layers) GTEST_SKIP() << "ogrinfo is not installed";
  for (const char* name : {"sections", "release_zones", "runout_zones"}) {
    EXPECT_NE(layers->find(std::string(": ") + name), std::string::npos) << *layers;
  }
  // Pages of two: GDAL has to follow the next links.
  const auto sections =
      output_of({"ogrinfo", "-ro", "-al", "-oo", "PAGE_SIZE=2", source, "sections"},
                folder->path() / "sections.txt");
  EXPECT_NE(sections->find("Feature Count: 4"), std::string::npos) << *sections;
  EXPECT_NE(sections->find("retrogression_m: Real"), std::string::npos) << *sections;
  std::size_t features = 0;
  for (auto at = sections->find("OGRFeature("); at != std::string::npos;
       at = sections->find("OGRFeature(", at + 1)) {
    ++features;
  }
  EXPECT_EQ(features, 4U);
  const auto zones =
      output_of({"ogrinfo", "-ro", "-al", "-spat", "0", "0", "1", "1", source, "release_zones"},
                folder->path() / "zones.txt");
  EXPECT_EQ(zones->find("OGRFeature("), std::string::npos) << *zones;
}

TEST_F(Clients, ResultsComeInEveryFormatAndAreKnownAgain) {
  const std::vector<std::pair<std::string, std::string>> formats = {
      {"gpkg", "SQLite format 3"}, {"geojson", "{"}, {"shp", "PK"}, {"fgb", "PK"}};
  for (const auto& [name, start] : formats) {
    const std::string path = std::string("/jobs/").append(job).append("/results?f=").append(name);
    const auto file = server->client().Get(path);
    ASSERT_EQ(file->status, 200) << file->body;
    EXPECT_TRUE(file->body.starts_with(start)) << name;
    const auto tag = file->get_header_value("ETag");
    EXPECT_EQ(server->client().Get(path, {{"If-None-Match", tag}})->status, 304) << name;
  }
}

TEST_F(Clients, EveryResultNamesVersionCaseAndDem) {
  const std::string dem = server->get("/rasters/bank")["sha256"];
  const json page = server->get("/jobs/" + job + "/sections?limit=3");
  EXPECT_EQ(page["numberMatched"], 4);
  EXPECT_EQ(page["numberReturned"], 3);
  EXPECT_EQ(page["links"][1]["rel"], "next");
  for (const auto& row : page["sections"]) {
    EXPECT_EQ(row["dem_sha256"], dem);
    EXPECT_EQ(row["case_sha256"].get<std::string>().size(), 64U);
    EXPECT_FALSE(row["version"].get<std::string>().empty());
  }
  for (const char* layer : {"sections", "release_zones", "runout_zones"}) {
    const json items = server->get(std::string("/collections/") + layer + "/items");
    ASSERT_FALSE(items["features"].empty());
    const json schema = server->get(std::string("/collections/") + layer + "/schema");
    for (const auto& feature : items["features"]) {
      EXPECT_EQ(feature["properties"]["dem_sha256"], dem) << layer;
      EXPECT_FALSE(feature["properties"]["version"].get<std::string>().empty()) << layer;
      EXPECT_EQ(feature["properties"].size(), schema["properties"].size()) << layer;
      for (const auto& [name, value] : feature["properties"].items()) {
        ASSERT_TRUE(schema["properties"].contains(name)) << layer << " " << name;
        const std::string type = schema["properties"][name]["type"];
        const bool fits = value.is_null() || (type == "string"    ? value.is_string()
                                              : type == "integer" ? value.is_number_integer()
                                                                  : value.is_number());
        EXPECT_TRUE(fits) << layer << " " << name << ": " << value;
      }
    }
    const json one = items["features"][0];
    const std::string own = "/collections/" + std::string(layer) + "/items/";
    EXPECT_EQ(server->get(own + one["id"].dump())["geometry"], one["geometry"]);
  }
}

TEST_F(Clients, TheLogOfASectionIsText) {
  const std::string path = "/jobs/" + job + "/sections/AA%27/log";
  const auto log = server->client().Get(path);
  ASSERT_EQ(log->status, 200);
  EXPECT_EQ(log->get_header_value("Content-Type"), "text/plain; charset=utf-8");
  EXPECT_FALSE(log->body.empty());
  const auto tail = server->client().Get(path + "?tail=40");
  EXPECT_LE(tail->body.size(), 40U);
  EXPECT_TRUE(log->body.ends_with(tail->body));
  EXPECT_EQ(server->client().Get("/jobs/" + job + "/sections/none/log")->status, 404);
}

TEST_F(Clients, EveryLineOfTheLogNamesItsJob) {
  std::istringstream lines(read_text(folder->path() / "data" / "server.log"));
  const std::regex form("time=\\S+Z level=[a-z]+ job=(\\S+) .+");
  int of_job = 0, all = 0;
  for (std::string line; std::getline(lines, line); ++all) {
    std::smatch match;
    ASSERT_TRUE(std::regex_match(line, match, form)) << line;
    of_job += match[1] == job ? 1 : 0;
  }
  EXPECT_GT(of_job, 8);
  EXPECT_GT(all, of_job);
}

TEST_F(Clients, ADryRunLaysOutAndEstimates) {
  json request = bank_region();
  request["dryRun"] = true;
  const auto answer =
      server->client().Post("/processes/map-region/execution", request.dump(), "application/json");
  ASSERT_EQ(answer->status, 200) << answer->body;
  const json document = json::parse(answer->body);
  EXPECT_EQ(document["sections"].size(), 4U);
  EXPECT_EQ(document["estimate"]["runs"], 4);
  EXPECT_NE(document["estimate"]["based_on"].get<std::string>().find("4 results"),
            std::string::npos);
  EXPECT_EQ(server->get("/jobs")["numberMatched"], 1);
}

TEST_F(Clients, OutputsAreChosen) {
  json request = bank_region();
  request["outputs"] = {{"release_zones", {{"transmissionMode", "value"}}}};
  request["response"] = "raw";
  const std::string raw = submit(request);
  ASSERT_EQ(server->wait_for_job(raw)["status"], "successful");
  EXPECT_EQ(server->get("/jobs/" + raw + "/results")["type"], "FeatureCollection");
  EXPECT_EQ(server->client().Delete("/jobs/" + raw)->status, 200);  // leaves one job to the others
}

TEST_F(Clients, ABackupOfTheRunningServerIsServed) {
  const auto copy = folder->path() / "backup";
  const Output ended =
      run_leda({"backup", "--data", (folder->path() / "data").string(), "--out", copy.string()});
  ASSERT_EQ(ended.exit_code, 0) << ended.errors;
  LedaServer restored(copy);
  EXPECT_EQ(restored.get("/jobs/" + job)["status"], "successful");
  const json items = restored.get("/collections/release_zones/items?job=" + job);
  EXPECT_EQ(items["numberMatched"], 3);
  EXPECT_FALSE(restored.get("/jobs/" + job + "/sections/AA%27")["log"].get<std::string>().empty());
  EXPECT_EQ(restored.client().Get("/rasters/bank/hillshade.png")->status, 200);
  const Output locked = run_leda({"purge", "--data", copy.string(), "--older-than-days", "0"});
  EXPECT_NE(locked.exit_code, 0) << "a server works there";
  const auto purged = restored.client().Post("/purge?older_than_days=0&jobs=true");
  ASSERT_EQ(purged->status, 200) << purged->body;
  EXPECT_GE(json::parse(purged->body)["run_folders"], 4);
  EXPECT_EQ(restored.client().Get("/jobs/" + job)->status, 404);
  EXPECT_EQ(restored.get("/collections/sections/items")["numberMatched"], 0);
}

TEST_F(Clients, AVrtIsNoRasterOverHttpEither) {
  const std::string vrt =
      "<VRTDataset rasterXSize=\"2\" rasterYSize=\"2\"><VRTRasterBand dataType=\"Float32\" "
      "band=\"1\"><SimpleSource><SourceFilename>/vsicurl/http://127.0.0.1:9/x.tif"
      "</SourceFilename></SimpleSource></VRTRasterBand></VRTDataset>";
  const auto answer = server->client().Post("/rasters?name=x.tif", vrt, "image/tiff");
  EXPECT_EQ(answer->status, 400) << answer->body;
  EXPECT_EQ(answer->body.find(folder->path().string()), std::string::npos) << answer->body;
  for (const char* name : {"..%2Fx", "%2Fvsimem%2Fx", "a%3Ab", "%3CVRT", "dem-0123456789ab"}) {
    const auto refused =
        server->client().Post(std::string("/rasters?name=") + name, vrt, "image/tiff");
    EXPECT_EQ(refused->status, 400) << name;
  }
  EXPECT_EQ(server->get("/rasters")["rasters"].size(), 1U);
}

}  // namespace
}  // namespace leda::tests
