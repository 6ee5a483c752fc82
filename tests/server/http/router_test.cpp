#include "server/http/router.hpp"

#include <gtest/gtest.h>

#include "server/http/routes.hpp"

namespace leda::server {
namespace {

TEST(Router, FindsTheRouteAndDecodesWhatItCaptures) {
  const auto match = find_route(routes(), "GET", "/jobs/j1/sections/AA%27%2Fx");
  ASSERT_NE(match.route, nullptr);
  EXPECT_EQ(match.route->path, "/jobs/{jobID}/sections/{name}");
  EXPECT_EQ(match.captured, (std::vector<std::string>{"j1", "AA'/x"}));
}

TEST(Router, AnswersHeadAsGet) {
  EXPECT_NE(find_route(routes(), "HEAD", "/healthz").route, nullptr);
}

TEST(Router, TellsTheMethodsOfAKnownPath) {
  const auto match = find_route(routes(), "PUT", "/rasters");
  EXPECT_EQ(match.route, nullptr);
  EXPECT_EQ(match.other_methods, (std::vector<std::string>{"POST", "GET"}));
}

TEST(Router, KnowsNoOtherPaths) {
  for (const char* path : {"/nothing", "/jobs/", "/jobs/j1/sections/", "//", "/jobs/%zz", "jobs"}) {
    const auto match = find_route(routes(), "GET", path);
    EXPECT_EQ(match.route, nullptr) << path;
    EXPECT_TRUE(match.other_methods.empty()) << path;
  }
}

TEST(Router, EveryRouteIsFoundByItsOwnPath) {
  for (const Route& route : routes()) {
    const auto match = find_route(routes(), std::string(route.method), std::string(route.path));
    EXPECT_EQ(match.route, &route) << route.method << " " << route.path;
  }
}

TEST(PercentEncoding, GoesThereAndBack) {
  const std::string text = "AA' é/%\r\n+?&=~";
  EXPECT_EQ(percent_decode(percent_encode(text)), text);
  EXPECT_EQ(percent_encode("AA'"), "AA%27");
}

TEST(PercentEncoding, RefusesBrokenEscapes) {
  for (const char* text : {"%", "%2", "%zz", "a%2x", "%+1"}) {
    EXPECT_FALSE(percent_decode(text)) << text;
  }
}

TEST(Router, NamesUnknownParameters) {
  const auto match = find_route(routes(), "GET", "/rasters");
  Call call;
  call.query = {{"f", "json"}, {"surprise", "1"}};
  EXPECT_EQ(unknown_parameters(*match.route, call), std::vector<std::string>{"surprise"});
}

TEST(Router, ARouteWithoutParametersKnowsNone) {
  const auto match = find_route(routes(), "GET", "/healthz");
  Call call;
  call.query = {{"f", "json"}};
  EXPECT_EQ(unknown_parameters(*match.route, call).size(), 1U);
}

}  // namespace
}  // namespace leda::server
