// The same way without HTTP.

#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <sstream>

#include "tests/server/temporary_folder.hpp"
#include "tests/service/leda_process.hpp"
#include "tests/service/region_on_a_bank.hpp"
#include "tests/service/small_bank.hpp"

namespace leda::tests {
namespace {

using nlohmann::json;

class CommandLine : public testing::Test {
 protected:
  /// The bank's region with one section and the DEM as a GeoTIFF-like file of its own.
  std::string region_file(const json& request) const {
    const auto file = folder.path() / "region.json";
    std::ofstream(file) << request.dump();
    return file.string();
  }
  /// Over HTTP, since the grid itself carries no CRS.
  void register_bank() const {
    write_bank(folder.path() / "bank.asc");
    std::ifstream file(folder.path() / "bank.asc", std::ios::binary);
    std::stringstream dem;
    dem << file.rdbuf();
    LedaServer server(data());
    const std::string path = std::string("/rasters") + bank_query;
    ASSERT_EQ(server.client().Post(path, dem.str(), "image/tiff")->status, 201);
    EXPECT_LT(server.end(), 5);
  }
  std::string data() const { return (folder.path() / "data").string(); }

  TemporaryFolder folder;
};

TEST_F(CommandLine, EveryCommandHasHelpAndTheProgramAVersion) {
  const std::string version = run_leda({"--version"}).text;
  EXPECT_TRUE(std::regex_match(
      version, std::regex("leda [0-9]+\\.[0-9]+\\.[0-9]+(\\+g[0-9a-f]{8}(-dirty)?)?\n")))
      << version;
  for (const char* command : {"serve", "map", "simulate", "compare", "export"}) {
    const Output help = run_leda({command, "--help"});
    EXPECT_EQ(help.exit_code, 0) << command;
    EXPECT_NE(help.text.find("Usage"), std::string::npos) << command;
  }
}

TEST_F(CommandLine, WrongUseIsToldWithCodeTwo) {
  EXPECT_EQ(run_leda({}).exit_code, 2);
  EXPECT_EQ(run_leda({"nothing"}).exit_code, 2);
  const Output mistyped = run_leda({"mpa", "region.json"});
  EXPECT_EQ(mistyped.exit_code, 2);
  EXPECT_NE(mistyped.errors.find("did you mean 'map'?"), std::string::npos) << mistyped.errors;
  EXPECT_EQ(run_leda({"nothing"}).errors.find("did you mean"), std::string::npos);
  EXPECT_EQ(run_leda({"serve"}).exit_code, 2);
  const Output open_to_all = run_leda({"serve", "--data", data(), "--listen", "0.0.0.0:0"});
  EXPECT_EQ(open_to_all.exit_code, 2);
  EXPECT_NE(open_to_all.errors.find("127.0.0.1"), std::string::npos) << open_to_all.errors;
}

TEST_F(CommandLine, AProgramWithoutItsCommandsSaysWhatIsMissing) {
  const auto alone = folder.path() / "leda";
  std::filesystem::copy_file(LEDA_PROGRAM, alone);
  const auto simulate = run_program({alone, "simulate", "--help"});
  EXPECT_EQ(simulate->exit_code, 0) << simulate->errors;
  const auto map = run_program({alone, "map", "--help"});
  EXPECT_EQ(map->exit_code, 1);
  const std::string missing = folder.path() / "leda-commands";
  EXPECT_NE(map->errors.find(missing + ": No such file"), std::string::npos) << map->errors;
}

// 5, and no crash: a server waits for space then, and does not count the try.
TEST_F(CommandLine, AFileThatCannotBeWrittenEndsARunWithCodeFive) {
  const std::string out = (folder.path() / "out").string();
  const std::string simulate =
      std::string(LEDA_PROGRAM) +
      " simulate " LEDA_SOURCE_DIR "/tests/data/cases/sainte-monique-AA.json --out " + out;
  for (const char* most_kib : {"1", "4", "16"}) {
    std::filesystem::remove_all(out);
    const auto run =
        run_program({"bash", "-c", std::string("ulimit -f ") + most_kib + "; " + simulate});
    EXPECT_EQ(run->exit_code, 5) << most_kib << " KiB: " << run->errors;
    EXPECT_NE(run->errors.find("File too large"), std::string::npos) << run->errors;
  }
}

TEST_F(CommandLine, FaultsOfARegionAreListedWithTheirPointers) {
  json request = bank_region();
  request["inputs"]["resolution"]["cell_m"] = -1;
  request["inputs"]["surprise"] = 1;
  const Output output = run_leda({"map", region_file(request), "--data", data()});
  EXPECT_EQ(output.exit_code, 2);
  EXPECT_NE(output.errors.find("/inputs/resolution/cell_m"), std::string::npos) << output.errors;
  EXPECT_NE(output.errors.find("/inputs/surprise"), std::string::npos) << output.errors;
}

TEST_F(CommandLine, ADemWithoutACrsIsRefused) {
  write_bank(folder.path() / "bank.asc");
  json request = bank_region();
  request["inputs"]["dem"] = (folder.path() / "bank.asc").string();
  const Output output = run_leda({"map", region_file(request), "--data", data()});
  EXPECT_EQ(output.exit_code, 2);
  EXPECT_NE(output.errors.find("coordinate reference system"), std::string::npos) << output.errors;
  EXPECT_NE(output.errors.find("--epsg"), std::string::npos) << output.errors;
}

// A grid without a CRS, named as it stands beside the request, wherever the command is given.
TEST_F(CommandLine, ADemBesideTheRequestIsFoundAndItsCrsStated) {
  write_bank(folder.path() / "bank.asc");
  json request = bank_region();
  request["inputs"]["dem"] = "bank.asc";
  request["inputs"]["dryRun"] = true;
  const Output output = run_leda({"map", region_file(request), "--data", data(), "--epsg", "2950",
                                  "--vertical-unit", "m", "--nodata", "none"});
  ASSERT_EQ(output.exit_code, 0) << output.errors;
  const json plan = json::parse(output.text);
  EXPECT_EQ(plan["dryRun"], true);
  // 12 m in cells of 2 m.
  EXPECT_NE(plan["sections"][0]["warnings"].dump().find("the bank is 6 cells high"),
            std::string::npos)
      << plan.dump(1);
  request["inputs"]["dem"] = "no-such.tif";
  const Output missing = run_leda({"map", region_file(request), "--data", data()});
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_NE(missing.errors.find("neither here nor beside region.json"), std::string::npos)
      << missing.errors;
}

TEST_F(CommandLine, WhatAFileIsToldARegisteredDemIsNot) {
  register_bank();
  const Output output = run_leda(
      {"map", region_file(bank_region()), "--data", data(), "--epsg", "2950", "--nodata", "0"});
  EXPECT_EQ(output.exit_code, 2);
  for (const char* part : {"--epsg: is of a file", "--nodata: is of a file"}) {
    EXPECT_NE(output.errors.find(part), std::string::npos) << output.errors;
  }
}

TEST_F(CommandLine, AMapIsMadeComparedAndExported) {
  register_bank();
  json request = bank_region();
  request["inputs"]["sections"].erase(2);
  const Output map = run_leda({"map", region_file(request), "--data", data(), "--workers", "2"});
  ASSERT_EQ(map.exit_code, 0) << map.errors;
  EXPECT_NE(map.text.find("AA'          at-rest"), std::string::npos) << map.text;
  std::istringstream words(map.text);
  std::string word, job;
  while (words >> word) job = word;

  const auto drawing = folder.path() / "compared.svg";
  const Output compared = run_leda(
      {"compare", job, "AA'", "BB'", "--data", data(), "--json", "--svg", drawing.string()});
  ASSERT_EQ(compared.exit_code, 0) << compared.errors;
  EXPECT_EQ(json::parse(compared.text)["sections"].size(), 2U);
  EXPECT_TRUE(std::filesystem::exists(drawing));
  const Output table = run_leda({"compare", job, "AA'", "BB'", "--data", data()});
  EXPECT_NE(table.text.find("BB' against AA'"), std::string::npos) << table.text;

  const auto package = folder.path() / "zones.gpkg";
  const Output exported =
      run_leda({"export", job, "--data", data(), "--format", "gpkg", "--out", package.string()});
  EXPECT_EQ(exported.exit_code, 0) << exported.errors;
  EXPECT_GT(std::filesystem::file_size(package), 10'000U);

  // The ending says the format, and a format that it contradicts is refused.
  const auto zones = folder.path() / "zones.geojson";
  EXPECT_EQ(run_leda({"export", job, "--data", data(), "--out", zones.string()}).exit_code, 0);
  std::ifstream written(zones);
  EXPECT_EQ(json::parse(written)["type"], "FeatureCollection");
  for (const auto& [format, name, exit_code] : {std::tuple{"shp", "zones.shp", 2},
                                                {"shp", "zones.shp.zip", 0},
                                                {"fgb", "zones.zip", 0},
                                                {"gpkg", "zones.geojson", 2}}) {
    const auto file = folder.path() / name;
    const Output other =
        run_leda({"export", job, "--data", data(), "--format", format, "--out", file.string()});
    EXPECT_EQ(other.exit_code, exit_code) << format << " " << name << " " << other.errors;
    EXPECT_EQ(std::filesystem::exists(file), exit_code == 0 || name == zones.filename());
  }
  EXPECT_EQ(run_leda({"export", job, "--data", data(), "--out", "zones.kml"}).exit_code, 2);

  EXPECT_EQ(run_leda({"compare", job, "AA'", "ZZ", "--data", data()}).exit_code, 2);
  EXPECT_EQ(run_leda({"export", "none", "--data", data(), "--out", "x.gpkg"}).exit_code, 2);
}

// Ends a command by SIGINT as soon as one of its runs has begun.
constexpr const char* interrupted_map = R"(
  "$0" map "$1" --data "$2" --workers 1 &
  until find "$2/runs" -name log.txt | grep -q . || ! kill -0 $!; do sleep 0.05; done
  kill -INT $!
  wait $!)";

TEST_F(CommandLine, AMapThatWasInterruptedGoesOnWithTheSameCommand) {
  register_bank();
  json request = bank_region();
  request["inputs"]["sections"] = json::array({request["inputs"]["sections"][0]});
  request["inputs"]["resolution"]["cell_m"] = 1.5;
  const std::string region = region_file(request);
  const auto interrupted =
      run_program({"bash", "-c", interrupted_map, LEDA_PROGRAM, region, data()});
  EXPECT_EQ(interrupted->exit_code, 4) << interrupted->errors;
  std::smatch told;
  const std::regex continues("the same command continues job (\\S+)");
  ASSERT_TRUE(std::regex_search(interrupted->errors, told, continues)) << interrupted->errors;

  const Output map = run_leda({"map", region, "--data", data()});
  EXPECT_EQ(map.exit_code, 0) << map.errors;
  EXPECT_TRUE(map.text.ends_with("successful " + told[1].str() + "\n")) << map.text;
  EXPECT_NE(map.errors.find("goes on with job " + told[1].str()), std::string::npos) << map.errors;

  const Output anew = run_leda({"map", region, "--data", data()});
  EXPECT_EQ(anew.exit_code, 0) << anew.errors;
  EXPECT_EQ(anew.text.find(told[1].str()), std::string::npos)
      << "a job that has ended is not meant";
}

// Standard error is free: who sends the JSON to a file sees there how far it is.
TEST_F(CommandLine, ProgressIsToldBesideJson) {
  register_bank();
  json request = bank_region();
  request["inputs"]["sections"].erase(2);
  const Output map =
      run_leda({"map", region_file(request), "--data", data(), "--workers", "2", "--json"});
  ASSERT_EQ(map.exit_code, 0) << map.errors;
  EXPECT_NE(map.errors.find("100 %  2 sections"), std::string::npos) << map.errors;
  EXPECT_EQ(json::parse(map.text)["sections"].size(), 2U);

  const auto file = folder.path() / "case.json";
  std::ofstream(file) << small_bank().dump();
  const std::string out = (folder.path() / "out").string();
  const Output run = run_leda({"simulate", file.string(), "--out", out, "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_NE(run.errors.find(" %  "), std::string::npos) << run.errors;
  EXPECT_EQ(json::parse(run.text)["status"], "at-rest");
  const Output silent =
      run_leda({"simulate", file.string(), "--out", out + "-silent", "--json", "--no-progress"});
  EXPECT_EQ(silent.errors, "");
}

// Clay far stronger than its bank: screened, stored, shown, and not simulated; where screening is
// asked to skip nothing, the same sections are simulated, and none of them moves.
TEST_F(CommandLine, ClearlyStableSectionsAreNotSimulated) {
  register_bank();
  json request = bank_region();
  request["inputs"]["sections"].erase(2);
  request["inputs"]["soil"]["materials"]["clay"]["peak_strength_kPa"] = 300;
  for (const bool skip : {true, false}) {
    request["inputs"]["screening"]["skip_stable"] = skip;
    const Output map = run_leda({"map", region_file(request), "--data", data(), "--workers", "2"});
    ASSERT_EQ(map.exit_code, 0) << map.errors;
    EXPECT_EQ(map.text.find("not simulated: ") != std::string::npos, skip) << map.text;
    EXPECT_NE(map.text.find("AA'          stable"), std::string::npos) << map.text;
    std::istringstream words(map.text);
    std::string word, job;
    while (words >> word) job = word;
    const Output compared = run_leda({"compare", job, "AA'", "BB'", "--data", data(), "--json"});
    const json section = json::parse(compared.text)["sections"][0];
    EXPECT_EQ(section["screening"]["decision"], "stable");
    EXPECT_EQ(section["result"].is_null(), skip);
    EXPECT_GT(section["screening"]["factor_of_safety"]["undrained"]["bishop"], 2);
  }
}

}  // namespace
}  // namespace leda::tests
