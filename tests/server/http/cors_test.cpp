#include "server/http/cors.hpp"

#include "tests/server/http/http_fixture.hpp"

namespace leda::server {
namespace {

TEST(Cors, OriginsThatCantBeAreNamed) {
  EXPECT_TRUE(
      AllowedOrigins({"https://maps.example.org", "http://127.0.0.1:3000"}).faults(false).empty());
  for (const char* origin : {"maps.example.org", "https://maps.example.org/", "https://", "null",
                             "https://*.example.org", "ftp://maps.example.org"}) {
    const auto faults = AllowedOrigins({origin}).faults(true);
    ASSERT_EQ(faults.size(), 1U) << origin;
    EXPECT_NE(faults[0].find(origin), std::string::npos);
  }
  EXPECT_EQ(AllowedOrigins({"*"}).faults(false).size(), 1U) << "any page could do all";
  EXPECT_TRUE(AllowedOrigins({"*"}).faults(true).empty());
}

/// A server that lets in the pages of one origin.
class CorsOverHttp : public testing::Test {
 protected:
  CorsOverHttp() { spdlog::set_level(spdlog::level::off); }
  static ServiceOptions options() {
    ServiceOptions options;
    options.program = "/bin/true";
    return options;
  }
  httplib::Result get(const std::string& origin, const std::string& path) {
    return client.Get(path, {{"Origin", origin}});
  }

  const std::string maps = "https://maps.example.org";
  tests::TemporaryFolder folder;
  Service service{folder.path(), options()};
  Site site{service,
            {.limits = {}, .tokens = {}, .origins = AllowedOrigins({maps}), .public_url = {}}};
  HttpServer http{site, {"127.0.0.1", 0}};
  httplib::Client client{site.url};
};

TEST_F(CorsOverHttp, ItsPagesMayReadAnswersAndProblems) {
  for (const char* path : {"/jobs", "/nothing", "/jobs?limit=x"}) {
    const auto answer = get(maps, path);
    EXPECT_EQ(answer->get_header_value("Access-Control-Allow-Origin"), maps) << path;
    EXPECT_NE(answer->get_header_value("Access-Control-Expose-Headers").find("ETag"),
              std::string::npos);
    EXPECT_EQ(answer->get_header_value("Vary"), "Origin") << path;
  }
  EXPECT_EQ(get(maps, "/jobs")->status, 200);
}

TEST_F(CorsOverHttp, OthersMayNot) {
  const auto refused = get("https://evil.example.org", "/jobs");
  EXPECT_EQ(refused->status, 403);
  EXPECT_FALSE(refused->has_header("Access-Control-Allow-Origin"));
  const auto plain = client.Get("/jobs");
  EXPECT_EQ(plain->status, 200);
  EXPECT_FALSE(plain->has_header("Access-Control-Allow-Origin"));
  EXPECT_EQ(plain->get_header_value("Vary"), "Origin") << "a cache must not give this to the page";
}

TEST_F(CorsOverHttp, APreflightIsAnsweredWithTheMethods) {
  const auto answer = client.Options("/processes/map-region/execution",
                                     {{"Origin", maps}, {"Access-Control-Request-Method", "POST"}});
  EXPECT_EQ(answer->status, 204);
  EXPECT_EQ(answer->get_header_value("Access-Control-Allow-Origin"), maps);
  EXPECT_EQ(answer->get_header_value("Access-Control-Allow-Methods"), "POST, OPTIONS");
  EXPECT_NE(answer->get_header_value("Access-Control-Allow-Headers").find("Authorization"),
            std::string::npos);
}

TEST_F(HttpServerTest, WithoutTheSettingNoPageOfOthersIsLetIn) {
  const auto answer = client.Get("/jobs", {{"Origin", "https://maps.example.org"}});
  expect_problem(answer, 403, "a foreign origin");
  EXPECT_NE(answer->body.find("--cors-origin"), std::string::npos) << answer->body;
  EXPECT_FALSE(client.Get("/jobs")->has_header("Vary"));
}

}  // namespace
}  // namespace leda::server
