#include "server/http/accept.hpp"

#include <algorithm>

#include "server/page/page_files.hpp"
#include "tests/server/http/http_fixture.hpp"

namespace leda::server {
namespace {

double quality(const char* accept, const char* type) { return wanted(accept, type).quality; }

TEST(Accept, TheEntryThatFitsBestDecides) {
  EXPECT_EQ(quality("", "text/csv"), 1);
  EXPECT_EQ(quality("*/*;q=0.1", "text/csv"), 0.1);
  EXPECT_EQ(quality("text/*;q=0.5, */*;q=0.9", "text/csv"), 0.5);
  EXPECT_EQ(quality("text/csv;q=0, text/*", "text/csv"), 0);
  EXPECT_EQ(quality("TEXT/CSV ; charset=utf-8 ; Q=0.25", "text/csv"), 0.25);
  EXPECT_EQ(quality("image/png", "text/csv"), 0);
  EXPECT_EQ(quality("text/csv;q=2", "text/csv"), 0);
}

TEST(Accept, DialectsOfJsonAreJson) {
  EXPECT_EQ(quality("application/json", "application/geo+json"), 1);
  EXPECT_EQ(quality("application/vnd.oai.openapi+json;version=3.0", "application/json"), 1);
  EXPECT_EQ(quality("application/xml", "application/json"), 0);
}

TEST(Accept, WhatIsNamedWinsOverWhatIsLetIn) {
  EXPECT_GT(wanted("text/html,*/*", "text/html"), wanted("text/html,*/*", "application/json"));
}

class AcceptOverHttp : public HttpServerTest {
 protected:
  httplib::Result get(const std::string& path, const std::string& accept) {
    return client.Get(path, {{"Accept", accept}});
  }
};

TEST_F(AcceptOverHttp, ABrowserGetsHtmlAndOthersJson) {
  const char* html = "text/html; charset=utf-8";
  const auto browser = get("/", "text/html,application/xhtml+xml,application/xml;q=0.9,*/*;q=0.8");
  EXPECT_EQ(browser->get_header_value("Content-Type"), html);
  const auto [vary, last] = browser->headers.equal_range("Vary");
  EXPECT_TRUE(std::any_of(vary, last, [](const auto& h) { return h.second == "Accept"; }));
  EXPECT_EQ(get("/", "text/html;q=0.1, application/json")->get_header_value("Content-Type"),
            "application/json");
  EXPECT_EQ(get("/?f=html", "application/json")->get_header_value("Content-Type"), html);
}

TEST_F(AcceptOverHttp, WhatNobodyCanMakeIsRefusedWithWhatThereIs) {
  for (const auto& [path, accept] : std::vector<std::pair<std::string, std::string>>{
           {"/", "application/xml"},
           {"/jobs", "text/csv"},
           {"/api", "application/yaml"},
           {"/collections/sections/items", "application/gml+xml"},
           {"/healthz", "text/html"},
           {"/metrics", "application/json"}}) {
    const auto answer = get(path, accept);
    expect_problem(answer, 406, path);
    EXPECT_NE(answer->body.find("there is "), std::string::npos) << answer->body;
  }
  EXPECT_EQ(get("/jobs?f=json", "text/csv")->status, 200) << "f= says it more plainly";
}

TEST_F(AcceptOverHttp, AFileThatIsNamedIsHeldToItsOwnType) {
  if (page_files().empty()) GTEST_SKIP() << "built without Node.js";
  EXPECT_EQ(get("/page/page.css", "text/css,*/*;q=0.1")->status, 200);
  EXPECT_EQ(get("/page/page.css", "text/css")->status, 200);
  expect_problem(get("/page/page.css", "text/javascript"), 406, "a script that is a style");
  expect_problem(get("/page/page.css", "image/png"), 406, "nothing of the page");
}

// As these programs send them.
TEST_F(AcceptOverHttp, ProgramsGetWhatTheyCanRead) {
  const std::string prometheus =
      "application/openmetrics-text;version=1.0.0;q=0.5,text/plain;version=0.0.4;q=0.3,*/*;q=0.1";
  EXPECT_EQ(get("/metrics", prometheus)->status, 200);
  const std::string gdal =
      "application/vnd.oai.openapi+json;version=3.0, application/openapi+json;q=0.9, "
      "application/json;q=0.8";
  EXPECT_EQ(get("/api", gdal)->status, 200);
  EXPECT_EQ(get("/collections/sections/schema", "application/schema+json")->status, 200);
  EXPECT_EQ(get("/collections/sections/items", "application/geo+json, application/json")->status,
            200);
  EXPECT_EQ(client.Get("/jobs")->status, 200);
}

}  // namespace
}  // namespace leda::server
