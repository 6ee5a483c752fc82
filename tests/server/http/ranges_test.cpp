#include "server/http/ranges.hpp"

#include <fstream>

#include "server/http/routes.hpp"
#include "server/layers/rasters.hpp"
#include "tests/db/samples.hpp"
#include "tests/server/http/http_fixture.hpp"

namespace leda::server {
namespace {

using Ranges = std::vector<ByteRange>;

TEST(Ranges, AreReadAsTheStandardHasThem) {
  EXPECT_EQ(wanted_ranges("bytes=0-99", 200), (Ranges{{0, 99}}));
  EXPECT_EQ(wanted_ranges("bytes=150-", 200), (Ranges{{150, 199}}));
  EXPECT_EQ(wanted_ranges("bytes=-50", 200), (Ranges{{150, 199}}));
  EXPECT_EQ(wanted_ranges("bytes=-500", 200), (Ranges{{0, 199}}));
  EXPECT_EQ(wanted_ranges("bytes=190-999", 200), (Ranges{{190, 199}}));
  EXPECT_EQ(wanted_ranges("bytes=0-0, 5-6 ,-1", 200), (Ranges{{0, 0}, {5, 6}, {199, 199}}));
}

TEST(Ranges, BeyondTheEndThereIsNothing) {
  EXPECT_EQ(wanted_ranges("bytes=200-", 200), Ranges{});
  EXPECT_EQ(wanted_ranges("bytes=-0", 200), Ranges{});
  EXPECT_EQ(wanted_ranges("bytes=0-", 0), Ranges{});
  EXPECT_EQ(wanted_ranges("bytes=500-600,0-9", 200), (Ranges{{0, 9}}));
}

TEST(Ranges, WhatIsNotUnderstoodOrTooMuchIsAnsweredWhole) {
  for (const char* range :
       {"", "items=0-1", "bytes=", "bytes=-", "bytes=x-1", "bytes=1-x", "bytes=9-1", "bytes=1",
        "bytes=0-99999999999999999999", "bytes=0-150,100-199", "bytes=0--1"}) {
    EXPECT_EQ(wanted_ranges(range, 200), std::nullopt) << range;
  }
  std::string many = "bytes=0-0";
  for (int i = 1; i <= 16; ++i) many += ',' + std::to_string(i) + '-' + std::to_string(i);
  EXPECT_EQ(wanted_ranges(many, 200), std::nullopt);
}

/// Beside what stands in memory there is a file, the picture of a DEM.
class RangesOverHttp : public HttpServerTest {
 protected:
  void SetUp() override {
    const auto raster = db::samples::raster();
    service.store.add_raster(raster);
    for (int i = 0; i < 200'000; ++i) picture += static_cast<char>('a' + i % 23);
    std::ofstream(hillshade_file(service.data, raster), std::ios::binary) << picture;
  }
  httplib::Result get(const std::string& path, const std::string& range) {
    return client.Get(path, {{"Range", range}});
  }
  const std::string picture_path = "/rasters/valley/hillshade.png";
  std::string picture;
};

TEST_F(RangesOverHttp, APartOfAFileIsToldAsAPart) {
  const auto part = get(picture_path, "bytes=100000-199998");
  ASSERT_TRUE(part);
  EXPECT_EQ(part->status, 206);
  EXPECT_EQ(part->get_header_value("Content-Range"), "bytes 100000-199998/200000");
  EXPECT_EQ(part->get_header_value("Content-Length"), "99999");
  EXPECT_EQ(part->body, picture.substr(100'000, 99'999));
}

TEST_F(RangesOverHttp, APictureThatStandsDoesNotWaitForOneThatIsDrawn) {
  const db::Turns::Turn another_is_drawn(site.hillshades);
  client.set_read_timeout(std::chrono::seconds(5));
  const auto answer = client.Get(picture_path);
  ASSERT_TRUE(answer) << "it waits for its turn";
  EXPECT_EQ(answer->body, picture);
}

TEST_F(RangesOverHttp, ADownloadThatWasCutOffGoesOn) {
  const auto whole = client.Get(picture_path);
  EXPECT_EQ(whole->status, 200);
  EXPECT_EQ(whole->get_header_value("Accept-Ranges"), "bytes");
  EXPECT_EQ(whole->body, picture);
  const std::string tag = whole->get_header_value("ETag");
  const auto rest = client.Get(picture_path, {{"Range", "bytes=5000-"}, {"If-Range", tag}});
  EXPECT_EQ(rest->status, 206);
  EXPECT_EQ(picture.substr(0, 5000) + rest->body, picture);
  const auto changed = client.Get(picture_path, {{"Range", "bytes=5000-"}, {"If-Range", "\"x\""}});
  EXPECT_EQ(changed->status, 200) << "the file is another one than what the client has half of";
  EXPECT_EQ(changed->body, picture);
}

TEST_F(RangesOverHttp, BeyondTheEndIsARefusalThatTellsTheLength) {
  for (const char* range : {"bytes=200000-", "bytes=99999999-", "bytes=-0"}) {
    const auto answer = get(picture_path, range);
    expect_problem(answer, 416, range);
    EXPECT_EQ(answer->get_header_value("Content-Range"), "bytes */200000");
    EXPECT_EQ(answer->get_header_value("Content-Length"), std::to_string(answer->body.size()));
  }
}

TEST_F(RangesOverHttp, SeveralComeInParts) {
  const auto answer = get(picture_path, "bytes=0-9,70000-70004");
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->status, 206);
  const std::string type = answer->get_header_value("Content-Type");
  const std::string start = "multipart/byteranges; boundary=";
  ASSERT_TRUE(type.starts_with(start)) << type;
  const std::string boundary = type.substr(start.size());
  EXPECT_EQ(answer->body, "--" + boundary +
                              "\r\nContent-Type: image/png\r\nContent-Range: bytes 0-9/200000\r\n"
                              "\r\n" +
                              picture.substr(0, 10) + "\r\n--" + boundary +
                              "\r\nContent-Type: image/png\r\nContent-Range: bytes "
                              "70000-70004/200000\r\n\r\n" +
                              picture.substr(70'000, 5) + "\r\n--" + boundary + "--\r\n");
}

TEST_F(RangesOverHttp, AHeadHasTheLengthOfTheWhole) {
  const auto head = client.Head(picture_path, {{"Range", "bytes=0-9"}});
  EXPECT_EQ(head->status, 200);
  EXPECT_EQ(head->get_header_value("Content-Length"), "200000");
  EXPECT_EQ(head->get_header_value("Accept-Ranges"), "bytes");
}

// Whether a client asks for parts is nothing that a handler has to know.
TEST_F(RangesOverHttp, EveryRouteAnswersInParts) {
  int tried = 0;
  for (const Route& route : routes()) {
    const std::string path(route.path);
    if (route.method != "GET" || path.find('{') != std::string::npos) continue;
    const auto whole = client.Get(path);
    ASSERT_TRUE(whole) << path;
    if (whole->status != 200) continue;
    const auto part = client.Get(path, {{"Range", "bytes=2-11"}, {"Accept-Encoding", "gzip"}});
    EXPECT_EQ(part->status, 206) << path;
    EXPECT_EQ(part->body, whole->body.substr(2, 10)) << path;
    EXPECT_EQ(get(path, "bytes=9999999-")->status, 416) << path;
    ++tried;
  }
  EXPECT_GE(tried, 8);
}

TEST_F(RangesOverHttp, OfAProblemThereAreNoParts) {
  expect_problem(get("/jobs/none", "bytes=0-3"), 404, "a problem is told whole");
}

}  // namespace
}  // namespace leda::server
