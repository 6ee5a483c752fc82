#include "server/http/problem_answer.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace leda::server {
namespace {

using nlohmann::json;

TEST(Problem, CarriesEveryFaultWithItsPointer) {
  const Problem problem(Failure::invalid_request, "two faults", {{"/a", "one"}, {"/b/0", "two"}});
  const Answer answer = to_answer(problem, "/processes/map-region/execution");
  EXPECT_EQ(answer.status, 400);
  EXPECT_EQ(answer.type, "application/problem+json");
  const json document = json::parse(answer.body);
  EXPECT_EQ(document["status"], 400);
  EXPECT_EQ(document["detail"], "two faults");
  EXPECT_EQ(document["instance"], "/processes/map-region/execution");
  EXPECT_EQ(document["errors"], json::parse(R"([{"pointer": "/a", "detail": "one"},
                                                {"pointer": "/b/0", "detail": "two"}])"));
}

TEST(Problem, UsesTheTypesOfTheStandard) {
  const json document = json::parse(to_answer(Problem(Failure::no_such_job, ""), "/jobs/x").body);
  EXPECT_EQ(document["type"],
            "http://www.opengis.net/def/exceptions/ogcapi-processes-1/1.0/no-such-job");
  EXPECT_FALSE(document.contains("errors"));
}

TEST(Problem, SaysWhenToComeBack) {
  const Answer answer = to_answer(Problem(Failure::too_busy, "full"), "/");
  EXPECT_EQ(answer.status, 503);
  ASSERT_EQ(answer.headers.size(), 1U);
  EXPECT_EQ(answer.headers[0].first, "Retry-After");
}

TEST(Problem, WhatIsOursIsAServersError) {
  for (auto failure = Failure::invalid_request; failure <= Failure::internal;
       failure = static_cast<Failure>(static_cast<int>(failure) + 1)) {
    EXPECT_EQ(is_ours(failure), status_of(failure) >= 500) << status_of(failure);
  }
}

TEST(Problem, TextThatIsNotUtf8DoesNotBreakTheAnswer) {
  const Answer answer = to_answer(Problem(Failure::invalid_request, "\xff\xfe"), "/\xc3");
  EXPECT_TRUE(json::accept(answer.body));
}

}  // namespace
}  // namespace leda::server
