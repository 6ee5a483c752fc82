// Requests that can't be served: answered with all their faults, each with its pointer, and nothing
// is changed.

#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <functional>
#include <iterator>
#include <set>

#include "tests/profiles/drawn_dem.hpp"
#include "tests/profiles/trap_rasters.hpp"
#include "tests/server/temporary_folder.hpp"
#include "tests/service/leda_process.hpp"
#include "tests/service/region_on_a_bank.hpp"

namespace leda::tests {
namespace {

using nlohmann::json;

std::string whole(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

class BadRegions : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder = new TemporaryFolder;
    write_bank(folder->path() / "bank.asc");
    server = new LedaServer(folder->path() / "data");
    const auto raster = server->client().Post(std::string("/rasters") + bank_query,
                                              whole(folder->path() / "bank.asc"), "image/tiff");
    ASSERT_TRUE(raster);
    ASSERT_EQ(raster->status, 201) << raster->body;
  }
  static void TearDownTestSuite() {
    delete server;
    delete folder;
  }
  void TearDown() override { EXPECT_EQ(server->get("/jobs")["numberMatched"], 0); }

  static httplib::Result post(const std::string& body) {
    return server->client().Post("/processes/map-region/execution", body, "application/json");
  }

  /// The pointers of the faults that a changed request is answered with.
  static std::set<std::string> faults(const std::function<void(json&)>& change) {
    json request = bank_region();
    change(request["inputs"]);
    return faults_of(request.dump());
  }

  static std::set<std::string> faults_of(const std::string& body) {
    const auto answer = post(body);
    EXPECT_TRUE(answer);
    if (!answer) return {};
    EXPECT_EQ(answer->status, 400) << answer->body;
    EXPECT_EQ(answer->get_header_value("Content-Type"), "application/problem+json");
    std::set<std::string> pointers;
    const json problem = json::parse(answer->body);
    for (const auto& error : problem.value("errors", json::array())) {
      EXPECT_FALSE(error["detail"].get<std::string>().empty());
      pointers.insert(error["pointer"].get<std::string>());
    }
    return pointers;
  }

  using Pointers = std::set<std::string>;
  static inline TemporaryFolder* folder = nullptr;
  static inline LedaServer* server = nullptr;
};

TEST_F(BadRegions, NoJson) {
  for (const char* body : {"", " ", "{", "[1", "\"text\"", "{\"inputs\": {}} {}"}) {
    const auto answer = post(body);
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->status, 400) << body;
  }
}

TEST_F(BadRegions, NotANumber) {
  std::string body = bank_region().dump();
  const std::string cell = "\"cell_m\":2";
  body.replace(body.find(cell), cell.size(), "\"cell_m\":NaN");
  EXPECT_EQ(post(body)->status, 400);
}

TEST_F(BadRegions, UnknownKeys) {
  EXPECT_EQ(faults([](json& in) {
              in["cell_size"] = 1;
              in["soil"]["materials"]["clay"]["strength"] = 1;
            }),
            (Pointers{"/inputs/cell_size", "/inputs/soil/materials/clay/strength"}));
}

TEST_F(BadRegions, AllFaultsAtOnce) {
  EXPECT_EQ(faults([](json& in) {
              in["resolution"]["cell_m"] = 0;
              in["soil"]["materials"]["clay"]["poisson_ratio"] = 0.7;
              in["sections"][2]["spacing_m"] = -5;
            }),
            (Pointers{"/inputs/resolution/cell_m", "/inputs/soil/materials/clay/poisson_ratio",
                      "/inputs/sections/2/spacing_m"}));
}

TEST_F(BadRegions, MissingLayers) {
  EXPECT_EQ(faults([](json& in) { in["soil"].erase("layers"); }), Pointers{"/inputs/soil/layers"});
  EXPECT_EQ(faults([](json& in) { in["soil"]["layers"] = json::array(); }),
            Pointers{"/inputs/soil/layers"});
}

TEST_F(BadRegions, LayersThatCross) {
  const auto found = faults([](json& in) {
    in["soil"]["layers"] = json::parse(R"([{"material": "crust", "bottom_m": 4},
                                           {"material": "crust", "bottom_m": 9},
                                           {"material": "clay"}])");
  });
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(found.begin()->starts_with("/inputs/soil/layers/1")) << *found.begin();
}

TEST_F(BadRegions, AMaterialThatIsNotDefined) {
  EXPECT_EQ(faults([](json& in) { in["soil"]["layers"][1]["material"] = "mud"; }),
            Pointers{"/inputs/soil/layers/1/material"});
}

TEST_F(BadRegions, StrengthsInTheWrongOrder) {
  const auto found = faults(
      [](json& in) { in["soil"]["materials"]["clay"]["softening"]["remolded_strength_kPa"] = 50; });
  ASSERT_FALSE(found.empty());
  for (const auto& pointer : found) {
    EXPECT_TRUE(pointer.starts_with("/inputs/soil/materials/clay/")) << pointer;
  }
}

TEST_F(BadRegions, ALineOutsideTheDem) {
  const auto found = faults([](json& in) { in["sections"][1]["line"][0] = {379000, 5113300}; });
  ASSERT_FALSE(found.empty());
  EXPECT_TRUE(found.begin()->starts_with("/inputs/sections/1")) << *found.begin();
}

TEST_F(BadRegions, ALineOverNoData) {
  const auto found = faults([](json& in) {
    in["sections"][0]["line"] = {{380300, 5113020}, {380580, 5113020}};
  });
  ASSERT_FALSE(found.empty());
  EXPECT_TRUE(found.begin()->starts_with("/inputs/sections/0")) << *found.begin();
}

TEST_F(BadRegions, ALineThatCrossesItself) {
  const auto found = faults([](json& in) {
    in["sections"][1]["line"] = {
        {380200, 5113300}, {380380, 5113300}, {380380, 5113340}, {380290, 5113200}};
  });
  ASSERT_FALSE(found.empty());
  EXPECT_TRUE(found.begin()->starts_with("/inputs/sections/1")) << *found.begin();
}

TEST_F(BadRegions, MoreSectionsThanAJobMayHave) {
  const auto along = faults([](json& in) { in["sections"][2]["spacing_m"] = 0.016; });
  ASSERT_FALSE(along.empty());
  EXPECT_TRUE(along.begin()->starts_with("/inputs/sections")) << *along.begin();
  const auto named = faults([](json& in) {
    const json line = in["sections"][0];
    in["sections"] = json::array();
    for (int i = 0; i < 20'001; ++i) {
      in["sections"].push_back(line);
      in["sections"].back()["name"] = "L" + std::to_string(i);
    }
  });
  ASSERT_FALSE(named.empty());
  EXPECT_TRUE(named.begin()->starts_with("/inputs/sections")) << *named.begin();
}

TEST_F(BadRegions, SectionsOfTheSameName) {
  const auto found = faults([](json& in) { in["sections"][1]["name"] = "AA'"; });
  ASSERT_FALSE(found.empty());
  EXPECT_TRUE(found.begin()->starts_with("/inputs/sections/1")) << *found.begin();
}

TEST_F(BadRegions, SoilThatDoesNotFitTheProfile) {
  const auto found = faults([](json& in) { in["soil"]["base_m"] = 15; });
  ASSERT_FALSE(found.empty());
  EXPECT_TRUE(found.begin()->starts_with("/inputs/soil")) << *found.begin();
}

TEST_F(BadRegions, AModelThatIsTooLarge) {
  const auto found = faults([](json& in) { in["resolution"]["cell_m"] = 0.005; });
  ASSERT_FALSE(found.empty());
  EXPECT_TRUE(found.begin()->starts_with("/inputs/resolution")) << *found.begin();
}

TEST_F(BadRegions, ADemThatIsNotThere) {
  EXPECT_EQ(faults([](json& in) { in["dem"] = "nowhere"; }), Pointers{"/inputs/dem"});
  for (const char* path : {"/etc/passwd", "../bank.asc", "/vsicurl/http://example.org/a.tif"}) {
    EXPECT_EQ(faults([&](json& in) { in["dem"] = path; }), Pointers{"/inputs/dem"}) << path;
  }
}

/// A TIFF of 200 bytes that declares 200 000 x 200 000 cells of float.
std::string huge_header() {
  std::string tiff("II*\0\10\0\0\0", 8);
  const auto put = [&tiff](std::uint32_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) tiff += static_cast<char>(value >> (8 * i) & 255U);
  };
  const std::vector<std::array<std::uint32_t, 2>> tags{
      {256, 200'000}, {257, 200'000}, {258, 32},      {259, 1}, {262, 1},
      {273, 8},       {277, 1},       {278, 200'000}, {279, 4}, {339, 3}};
  put(static_cast<std::uint32_t>(tags.size()), 2);
  for (const auto& [tag, value] : tags) {
    put(tag, 2);
    put(4, 2);  // LONG
    put(1, 4);
    put(value, 4);
  }
  put(0, 4);
  return tiff;
}

TEST_F(BadRegions, ARasterThatDeclaresAHugeGrid) {
  const auto answer = server->client().Post("/rasters?name=huge&epsg=2950&vertical_unit=m",
                                            huge_header(), "image/tiff");
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->status, 400) << answer->body;
  EXPECT_NE(answer->body.find("200000"), std::string::npos) << answer->body;
}

TEST_F(BadRegions, RastersThatAreTraps) {
  const test::TestFolder traps;
  test::write_trap_rasters(traps.path());
  for (const auto& entry : std::filesystem::directory_iterator(traps.path())) {
    const auto answer = server->client().Post("/rasters?name=" + entry.path().stem().string(),
                                              whole(entry.path()), "image/tiff");
    ASSERT_TRUE(answer) << entry.path();
    EXPECT_EQ(answer->status, 400) << entry.path() << ": " << answer->body;
  }
  EXPECT_EQ(server->get("/rasters")["rasters"].size(), 1U);
}

}  // namespace
}  // namespace leda::tests
