// QGIS, as users have it: it loads the layers from a running server and from the GeoPackage, which
// brings its styles along.

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>

#include "tests/server/temporary_folder.hpp"
#include "tests/service/leda_process.hpp"
#include "tests/service/region_on_a_bank.hpp"

namespace leda::tests {
namespace {

using nlohmann::json;

TEST(Qgis, LoadsTheLayersFromTheServerAndFromThePackage) {
  const auto has_qgis = run_program({"/usr/bin/python3", "-c", "import qgis.core"});
  if (!has_qgis || has_qgis->exit_code != 0) GTEST_SKIP() << "python3-qgis is not installed";
  const TemporaryFolder folder;
  write_bank(folder.path() / "bank.asc");
  LedaServer server(folder.path() / "data", {"--workers", "2"});
  std::ifstream file(folder.path() / "bank.asc", std::ios::binary);
  const std::string dem{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  server.client().Post(std::string("/rasters") + bank_query, dem, "application/octet-stream");
  const auto answer = server.client().Post("/processes/map-region/execution", bank_region().dump(),
                                           "application/json");
  ASSERT_EQ(answer->status, 201) << answer->body;
  const std::string job = json::parse(answer->body)["jobID"];
  ASSERT_EQ(server.wait_for_job(job)["status"], "successful");
  const auto package = folder.path() / "zones.gpkg", picture = folder.path() / "map.png";
  std::ofstream(package, std::ios::binary)
      << server.client().Get("/jobs/" + job + "/export?f=gpkg")->body;

  const auto said = run_program({"/usr/bin/python3",
                                 std::string(LEDA_SOURCE_DIR) + "/tests/service/read_in_qgis.py",
                                 server.url(), package.string(), picture.string()});
  ASSERT_TRUE(said);
  const json read = json::parse(said->text, nullptr, false);
  ASSERT_TRUE(read.is_object()) << said->text << said->errors;
  const std::set<std::pair<std::string, int>> wanted = {
      {"sections", 4}, {"release_zones", 3}, {"runout_zones", 3}};
  for (const char* source : {"served", "package"}) {
    for (const auto& [name, features] : wanted) {
      const json& layer = read[source][name];
      ASSERT_TRUE(layer["valid"]) << source << " " << name << layer;
      EXPECT_EQ(layer["features"], features) << source << " " << name;
      EXPECT_EQ(layer["geometries"], features);
      EXPECT_EQ(layer["asked_for_south_half"], layer["in_south_half"]) << "its own box";
      EXPECT_LT(layer["in_south_half"], features);
      EXPECT_EQ(layer["crs"], std::string(source) == "served" ? "EPSG:4326" : "EPSG:2950");
    }
  }
  // The styles of the package, not QGIS's random colours.
  EXPECT_EQ(read["package"]["release_zones"]["colours"], json::array({"#d73027"}));
  EXPECT_EQ(read["package"]["runout_zones"]["colours"], json::array({"#fdae61"}));
  EXPECT_EQ(read["package"]["sections"]["renderer"], "categorizedSymbol");
  EXPECT_GT(file_size(picture), 1000U);
}

}  // namespace
}  // namespace leda::tests
