// What the map page is served, and what it asks for beside the interface that all clients use.

#include <algorithm>
#include <cstring>
#include <fstream>

#include "db/result_file.hpp"
#include "server/jobs/process.hpp"
#include "server/layers/rasters.hpp"
#include "server/page/page_files.hpp"
#include "solver/section/frame.hpp"
#include "tests/db/frames.hpp"
#include "tests/db/samples.hpp"
#include "tests/server/http/http_fixture.hpp"
#include "tests/server/run_fixture.hpp"

namespace leda::server {
namespace {

class MapPage : public HttpServerTest {
 protected:
  static httplib::Headers packed(const char* accept) {
    return {{"Accept", accept}, {"Accept-Encoding", "gzip"}};
  }
};

TEST_F(MapPage, ABrowserGetsItWithAPolicyThatKeepsItToThisServer) {
  if (page_files().empty()) GTEST_SKIP() << "built without Node.js";
  const auto page = client.Get("/", packed("text/html,*/*;q=0.8"));
  ASSERT_EQ(page->status, 200);
  EXPECT_NE(page->body.find("page/page.js"), std::string::npos);
  const std::string policy = page->get_header_value("Content-Security-Policy");
  EXPECT_NE(policy.find("default-src 'none'"), std::string::npos);
  EXPECT_EQ(policy.find("unsafe"), std::string::npos) << policy;
  EXPECT_EQ(policy.find("http"), std::string::npos) << policy;
}

TEST_F(MapPage, ItsFilesComePackedOrPlainAndAreKnownAgain) {
  if (page_files().empty()) GTEST_SKIP() << "built without Node.js";
  std::size_t bytes = 0;
  for (const PageFile& file : page_files()) {
    bytes += file.gzip.size();
    if (file.name == "index.html") continue;
    const std::string path = "/page/" + std::string(file.name);
    const auto whole = client.Get(path, packed("*/*"));
    ASSERT_EQ(whole->status, 200) << path;
    EXPECT_EQ(whole->body, file.bytes) << "unpacked by the client";
    EXPECT_EQ(whole->get_header_value("Content-Encoding"), "gzip");
    const auto plain = client.Get(path, {{"Accept-Encoding", "identity"}});
    EXPECT_EQ(plain->body, file.bytes);
    const auto known = client.Get(
        path, {{"Accept-Encoding", "gzip"}, {"If-None-Match", whole->get_header_value("ETag")}});
    EXPECT_EQ(known->status, 304);
  }
  EXPECT_LT(bytes, 1'000'000U);
  expect_problem(client.Get("/page/nothing.js"), 404, "no such file");
}

/// A bank of 10 m on a DEM of 60 x 60 m.
class MapAnswers : public HttpServerTest {
 protected:
  void SetUp() override {
    const auto file = folder.path() / "bank.asc";
    std::ofstream out(file);
    out << "ncols 60\nnrows 60\nxllcorner 0\nyllcorner 0\ncellsize 1\nNODATA_value -9999\n";
    for (int row = 0; row < 60; ++row) {
      for (int column = 0; column < 60; ++column) {
        out << (row == 0 ? -9999 : std::clamp(10 * (40 - column) / 20, 0, 10)) << " ";
      }
      out << "\n";
    }
    out.close();
    const RegisterOptions options{.dem = {.vertical_unit = "m", .epsg = 2950, .limits = {}}};
    raster = register_raster(service.data, service.store, file, "bank", options).id;
  }

  httplib::Result lay_out(const std::string& sections) {
    return client.Post("/rasters/" + raster + "/layout",
                       R"({"inputs":{"sections":)" + sections + "}}", "application/json");
  }

  std::string raster;
};

TEST_F(MapAnswers, SectionsAreLaidOutAsAJobWould) {
  const auto answer = lay_out(R"([{"name":"AA'","line":[[2,30],[58,30]]}])");
  ASSERT_EQ(answer->status, 200) << answer->body;
  const json section = json::parse(answer->body)["sections"][0];
  EXPECT_EQ(section["name"], "AA'");
  EXPECT_NEAR(section["crest_m"][1].get<double>(), 10, 0.6);
  EXPECT_NEAR(section["toe_m"][1].get<double>(), 0, 0.6);
  EXPECT_LT(section["crest_m"][0].get<double>(), section["toe_m"][0].get<double>());
  EXPECT_GT(section["profile"].size(), 2U);
  EXPECT_EQ(section["trace"], json::parse("[[2,30],[58,30]]"));
}

TEST_F(MapAnswers, FaultsOfALayoutHaveThePointersOfARequest) {
  const auto outside = lay_out(R"([{"name":"AA'","line":[[2,30],[580,30]]}])");
  expect_problem(outside, 400, "outside");
  EXPECT_EQ(json::parse(outside->body)["errors"][0]["pointer"], "/inputs/sections/0/line/1");
  const auto unnamed = lay_out(R"([{"line":[[2,30],[58,30]]}])");
  expect_problem(unnamed, 400, "unnamed");
  EXPECT_EQ(json::parse(unnamed->body)["errors"][0]["pointer"], "/inputs/sections/0/name");
  expect_problem(
      client.Post("/rasters/none/layout", R"({"inputs":{"sections":[]}})", "application/json"), 400,
      "an empty list");
}

TEST_F(MapAnswers, GroundUnderAPoint) {
  const std::string path = "/rasters/" + raster + "/elevation?at=";
  EXPECT_EQ(ok(path + "5,30")["elevation_m"], 10);
  EXPECT_TRUE(ok(path + "5,59.5")["elevation_m"].is_null()) << "no data";
  EXPECT_TRUE(ok(path + "500,30")["elevation_m"].is_null()) << "outside";
  for (const char* wrong : {"", "5", "5,x", "1,2,3", "nan,1"}) {
    expect_problem(client.Get(path + wrong), 400, wrong);
  }
}

TEST_F(MapAnswers, ADemSaysItsProjectionForProgramsWithoutPROJ) {
  EXPECT_NE(ok("/rasters/" + raster)["proj4"].get<std::string>().find("+proj=tmerc"),
            std::string::npos);
}

TEST_F(MapAnswers, AJobOnTheMapHasItsSectionsInColumns) {
  db::JobRecord job = db::samples::job("done");
  job.raster = raster;
  job.state = db::JobState::successful;
  service.store.add_job(job);
  service.store.set_sections("done", db::samples::layout(3));
  const auto answer = client.Get("/jobs/done/map");
  ASSERT_EQ(answer->status, 200) << answer->body;
  const json map = json::parse(answer->body);
  EXPECT_EQ(map["crs"], "EPSG:2950");
  EXPECT_EQ(map["dem"], raster);
  for (const auto& [name, column] : map["sections"].items()) EXPECT_EQ(column.size(), 3U) << name;
  EXPECT_EQ(map["sections"]["name"][0], db::samples::layout(1).front().name);
  const httplib::Headers again{{"If-None-Match", answer->get_header_value("ETag")}};
  EXPECT_EQ(client.Get("/jobs/done/map", again)->status, 304);
  expect_problem(client.Get("/jobs/none/map"), 404, "no such job");
}

class Frames : public HttpServerTest {
 protected:
  void SetUp() override {
    db::JobRecord job = db::samples::job("done");
    job.process = "simulate-section";
    job.request = tests::simulate_request();
    service.store.add_job(job);
    const auto work = find_process(job.process)->open(job.request, {service.data, service.store});
    service.store.set_sections("done", work->plan());
    const auto section = service.store.sections("done").at(0);
    path = "/jobs/done/sections/" + section.name + "/frames";
    std::filesystem::create_directories(service.data.run("done-0-1"));
    service.store.start_run(section.id, "done-0-1");
  }

  void leave_frames() const {
    db::ResultFileWriter writer(service.data.run("done-0-1") / "fields.h5", {"crust", "S1", "B1"},
                                std::string(64, 'c'), "1");
    for (int i = 0; i < 5; ++i) writer.append(db::samples::frame(i, 40));
    writer.close();
  }

  static json head_of(const std::string& bytes) {
    std::uint32_t length = 0;
    std::memcpy(&length, bytes.data(), sizeof(length));
    return json::parse(bytes.substr(4, length));
  }

  /// Of the first frame: x, z and value follow each other.
  static double number_in(const std::string& bytes, std::size_t column, std::size_t particle) {
    std::uint32_t length = 0;
    std::memcpy(&length, bytes.data(), sizeof(length));
    std::uint16_t packed = 0;
    std::memcpy(&packed, bytes.data() + 4 + length + 2 * (column * 40 + particle), sizeof(packed));
    const json range = head_of(bytes)[column == 0 ? "x_m" : column == 1 ? "z_m" : "value"];
    const double least = range[0], most = range[1];
    return least + (most - least) * packed / 65535;
  }

  std::string path;
};

TEST_F(Frames, ComePackedAtSixBytesAParticle) {
  leave_frames();
  const auto answer = client.Get(path + "?first=1&count=3");
  ASSERT_EQ(answer->status, 200) << answer->body;
  const json head = head_of(answer->body);
  EXPECT_EQ(head["field"], "plastic_strain");
  EXPECT_EQ(head["times_s"].size(), 5U);
  EXPECT_EQ(head["particles"], json::parse("[40,40,40]"));
  EXPECT_EQ(answer->body.size() % 2, 0U);
  std::uint32_t length = 0;
  std::memcpy(&length, answer->body.data(), sizeof(length));
  EXPECT_EQ(answer->body.size(), 4U + length + 3U * 40U * 6U);
  const Frame frame = db::samples::frame(1, 40);
  for (const std::size_t i : {0U, 17U, 39U}) {
    EXPECT_NEAR(number_in(answer->body, 0, i), frame.x[i], 0.001);
    EXPECT_NEAR(number_in(answer->body, 1, i), frame.z[i], 0.001);
    EXPECT_NEAR(number_in(answer->body, 2, i), frame.plastic_strain[i], 0.001);
  }
}

TEST_F(Frames, SpeedAndMaterialAreMadeOfTheirArrays) {
  leave_frames();
  const Frame frame = db::samples::frame(0, 40);
  const auto speed = client.Get(path + "?field=speed&count=1");
  EXPECT_NEAR(number_in(speed->body, 2, 7), std::hypot(frame.velocity_x[7], frame.velocity_z[7]),
              0.01);
  const auto material = client.Get(path + "?field=material&count=1");
  EXPECT_NEAR(number_in(material->body, 2, 7), frame.material[7], 1e-3);
  EXPECT_EQ(head_of(material->body)["materials"], json::parse(R"(["crust","S1","B1"])"));
}

TEST_F(Frames, PastTheEndThereAreNone) {
  leave_frames();
  EXPECT_TRUE(head_of(client.Get(path + "?first=9")->body)["particles"].empty());
  expect_problem(client.Get(path + "?field=colour"), 400, "no such field");
}

TEST_F(Frames, AllOfThemAreHandedOutAsTheRunWroteThem) {
  leave_frames();
  const std::string whole = tests::read_text(service.data.run("done-0-1") / "fields.h5");
  const std::string fields = path.substr(0, path.rfind('/')) + "/fields.h5";
  const auto answer = client.Get(fields);
  ASSERT_EQ(answer->status, 200) << answer->body;
  EXPECT_EQ(answer->get_header_value("Content-Type"), "application/x-hdf5");
  EXPECT_EQ(answer->body, whole);
  const auto part = client.Get(fields, {httplib::make_range_header({{1, 3}})});
  EXPECT_EQ(part->status, 206);
  EXPECT_EQ(part->body, "HDF");
  const httplib::Headers again{{"If-None-Match", answer->get_header_value("ETag")}};
  EXPECT_EQ(client.Get(fields, again)->status, 304);
}

TEST_F(Frames, WhyThereAreNoFieldsIsSaid) {
  const std::string fields = path.substr(0, path.rfind('/')) + "/fields.h5";
  const auto going = client.Get(fields);
  expect_problem(going, 404, "the run is not over");
  EXPECT_NE(going->body.find("its run is not over"), std::string::npos) << going->body;
  expect_problem(client.Get("/jobs/done/sections/ZZ/fields.h5"), 404, "no such section");
}

TEST_F(Frames, ARunThatLeftNoneSaysSo) { expect_problem(client.Get(path), 404, "no fields.h5"); }

}  // namespace
}  // namespace leda::server
