#pragma once
// A server on a free port and a client that asks it, for what HTTP alone decides.

#include <gtest/gtest.h>
#include <httplib.h>
#include <spdlog/spdlog.h>

#include <nlohmann/json.hpp>
#include <string>

#include "server/http/http_server.hpp"
#include "tests/server/temporary_folder.hpp"

namespace leda::server {

using nlohmann::json;

/// A server without workers that give results: for what HTTP alone decides.
class HttpServerTest : public testing::Test {
 protected:
  static ServiceOptions options() {
    ServiceOptions options;
    options.program = "/bin/true";
    return options;
  }

  HttpServerTest() { spdlog::set_level(spdlog::level::off); }

  json ok(const std::string& path) {
    const auto answer = client.Get(path);
    EXPECT_TRUE(answer) << path;
    if (!answer) return {};
    EXPECT_EQ(answer->status, 200) << path << ": " << answer->body;
    return json::parse(answer->body);
  }

  static void expect_problem(const httplib::Result& answer, int status, const std::string& what) {
    ASSERT_TRUE(answer) << what;
    EXPECT_EQ(answer->status, status) << what << ": " << answer->body;
    EXPECT_EQ(answer->get_header_value("Content-Type"), "application/problem+json") << what;
    ASSERT_TRUE(json::accept(answer->body)) << what << ": " << answer->body;
    EXPECT_EQ(json::parse(answer->body)["status"], status) << what;
  }

  httplib::Result submit(const std::string& body, const std::string& key = "") {
    httplib::Headers headers;
    if (!key.empty()) headers.emplace("Idempotency-Key", key);
    return client.Post("/processes/simulate-section/execution", headers, body, "application/json");
  }

  tests::TemporaryFolder folder;
  Service service{folder.path(), options()};
  Site site{service};
  HttpServer http{site, {"127.0.0.1", 0}};
  httplib::Client client{site.url};
};

}  // namespace leda::server
