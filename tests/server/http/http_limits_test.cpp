// What HTTP refuses, and how it says so.

#include <atomic>
#include <thread>

#include "tests/db/samples.hpp"
#include "tests/server/http/http_fixture.hpp"
#include "tests/server/run_fixture.hpp"

namespace leda::server {
namespace {

/// A server with other limits than the fixture's.
struct ServerOfItsOwn {
  explicit ServerOfItsOwn(const ServiceOptions& options) : service(folder.path(), options) {}

  const tests::TemporaryFolder folder;
  Service service;
  Site site{service};
  HttpServer http{site, {"127.0.0.1", 0}};
};

TEST_F(HttpServerTest, WhatIsNotThereIsToldAsAProblem) {
  for (const char* path : {"/nothing", "/jobs/none", "/processes/none", "/rasters/none",
                           "/collections/none", "/collections/sections/items/7",
                           "/jobs/none/sections/x", "/jobs/none/events", "/jobs/%0d%0aX: y"}) {
    expect_problem(client.Get(path), 404, path);
  }
}

TEST_F(HttpServerTest, AWrongMethodIsToldWithTheRightOnes) {
  const auto answer = client.Put("/jobs", "", "text/plain");
  expect_problem(answer, 405, "PUT /jobs");
  EXPECT_EQ(answer->get_header_value("Allow"), "GET, HEAD, OPTIONS");
}

TEST_F(HttpServerTest, ParametersAreChecked) {
  for (const char* path :
       {"/jobs?limit=0", "/jobs?limit=ten", "/jobs?status=done", "/jobs?surprise=1",
        "/jobs?datetime=yesterday", "/jobs?datetime=2026-13-01", "/jobs?minDuration=-1",
        "/jobs?maxDuration=x", "/jobs?datetime=2026-01-01T25:00:00Z",
        "/collections/sections/items?bbox=1,2,3",
        "/collections/sections/items?bbox=380000,5113000,380600,5114000",
        "/collections/sections/items?bbox=1,2,3,nan", "/collections/sections/items?limit=-1",
        "/healthz?x=1", "/processes?f=xml"}) {
    expect_problem(client.Get(path), 400, path);
  }
}

TEST_F(HttpServerTest, AChunkedBodyIsRefused) {
  const auto answer = client.Post(
      "/processes/simulate-section/execution",
      [](std::size_t, httplib::DataSink& sink) {
        sink.os << "{}";
        sink.done();
        return true;
      },
      "application/json");
  expect_problem(answer, 411, "chunked");
}

TEST_F(HttpServerTest, AFormIsRefused) {
  const httplib::MultipartFormDataItems form{{"file", "x", "x.tif", "image/tiff"}};
  expect_problem(client.Post("/rasters?name=x", form), 415, "multipart");
}

TEST_F(HttpServerTest, OtherSitesMayNotSteerIt) {
  expect_problem(client.Get("/jobs", {{"Origin", "https://example.org"}}), 403, "Origin");
  expect_problem(client.Get("/jobs", {{"Host", "rebound.example.org"}}), 403, "Host");
  EXPECT_EQ(client.Get("/jobs", {{"Origin", site.url}})->status, 200);
}

TEST_F(HttpServerTest, ADocumentThatIsTooLargeIsRefused) {
  expect_problem(submit(std::string((16U << 20) + 1, ' ')), 413, "17 MB of blanks");
}

TEST_F(HttpServerTest, ABodyThatIsNoRequestChangesNothing) {
  for (const char* body : {"", "{", "[]", "null", "{\"inputs\": 1}", "\xff", "{\"inputs\": {}}",
                           "{\"inputs\": {\"case\": {}}, \"inputs\": {}}"}) {
    expect_problem(submit(body), 400, body);
  }
  EXPECT_EQ(ok("/jobs")["numberMatched"], 0);
}

TEST_F(HttpServerTest, OutputsMustBeThoseOfTheProcess) {
  json request = json::parse(tests::simulate_request());
  request["outputs"] = {{"surprise", json::object()}};
  const auto answer = submit(request.dump());
  expect_problem(answer, 400, "unknown output");
  EXPECT_EQ(json::parse(answer->body)["errors"][0]["pointer"], "/outputs/surprise");
  const auto with_format = [&](const json& format) {
    request["outputs"] = {{"sections", {{"format", format}}}};
    return submit(request.dump());
  };
  const auto as_table = with_format({{"mediaType", "text/csv"}});
  expect_problem(as_table, 400, "a form that outputs have not");
  EXPECT_EQ(json::parse(as_table->body)["errors"][0]["pointer"],
            "/outputs/sections/format/mediaType");
  expect_problem(with_format({{"encoding", "base64"}}), 400, "an encoding");
  EXPECT_EQ(with_format({{"mediaType", "application/json"}})->status, 201);
  request["outputs"] = {{"sections", json::object()}};
  EXPECT_EQ(submit(request.dump())->status, 201);
}

TEST_F(HttpServerTest, AGzipBombIsNoLargerThanItsLimit) {
  // 20 MB of blanks, 20 kB packed: the limit counts what comes out.
  client.set_compress(true);
  expect_problem(submit(std::string(20U << 20, ' ')), 413, "gzip bomb");
}

TEST_F(HttpServerTest, EventStreamsLeaveRoomForOthers) {
  SiteOptions few;
  few.limits.streams = 2;
  const tests::TemporaryFolder own_folder;
  Service own{own_folder.path(), options()};
  Site own_site{own, few};
  HttpServer own_http{own_site, {"127.0.0.1", 0}};
  db::JobRecord job;
  job.id = "open";
  job.process = "simulate-section";
  job.request = tests::simulate_request();
  own.store.add_job(job);  // the dispatcher is not told: it stays accepted
  const auto follow = [&](std::atomic<bool>& stop) {
    httplib::Client other(own_site.url);
    other.Get("/jobs/open/events", [&](const char*, std::size_t) { return !stop; });
  };
  std::atomic<bool> stop = false;
  std::thread first([&] { follow(stop); }), second([&] { follow(stop); });
  while (own_site.streams.taken() < 2) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  httplib::Client other(own_site.url);
  const auto third = other.Get("/jobs/open/events");
  expect_problem(third, 503, "a third stream");
  EXPECT_FALSE(third->get_header_value("Retry-After").empty());
  EXPECT_EQ(other.Get("/healthz")->status, 200);
  own.store.set_job_state("open", db::JobState::failed, "");
  first.join();
  second.join();
  // A client may see the end a moment before the server has put the stream away.
  const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (own_site.streams.taken() > 0 && std::chrono::steady_clock::now() < until) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  EXPECT_EQ(own_site.streams.taken(), 0);
}

TEST_F(HttpServerTest, AFullQueueSaysWhenToComeAgain) {
  ServiceOptions few = options();
  few.limits.unfinished_jobs = 1;
  ServerOfItsOwn own{few};
  db::JobRecord job;
  job.id = "open";
  job.process = "simulate-section";
  own.service.store.add_job(job);
  httplib::Client other(own.site.url);
  const auto answer = other.Post("/processes/simulate-section/execution", tests::simulate_request(),
                                 "application/json");
  expect_problem(answer, 429, "full queue");
  EXPECT_EQ(answer->get_header_value("Retry-After"), "30");
}

TEST_F(HttpServerTest, ADryRunIsUnderTheLimitsOfJobs) {
  ServiceOptions few = options();
  few.limits.unfinished_jobs = 1;
  few.limits.layouts = 1;
  ServerOfItsOwn own{few};
  auto request = json::parse(tests::simulate_request());
  request["dryRun"] = true;
  const auto ask = [&] {
    return httplib::Client(own.site.url)
        .Post("/processes/simulate-section/execution", request.dump(), "application/json");
  };
  EXPECT_EQ(ask()->status, 200);
  {
    const auto slot = own.service.layouts.take();
    expect_problem(ask(), 503, "another layout is going on");
  }
  db::JobRecord job;
  job.id = "open";
  job.process = "simulate-section";
  own.service.store.add_job(job);
  expect_problem(ask(), 429, "a job would not be taken either");
  own.service.store.set_job_state("open", db::JobState::failed, "");
  EXPECT_EQ(ask()->status, 200);
}

TEST_F(HttpServerTest, ARetryIsUnderTheLimitOfUnfinishedJobs) {
  ServiceOptions few = options();
  few.limits.unfinished_jobs = 1;
  ServerOfItsOwn own{few};
  db::JobRecord job;
  job.process = "simulate-section";
  for (const char* id : {"open", "failed"}) {
    job.id = id;
    own.service.store.add_job(job);
  }
  own.service.store.set_sections("failed", {db::samples::section("AA'", 0)});
  own.service.store.set_job_state("failed", db::JobState::failed, "");
  httplib::Client other(own.site.url);
  expect_problem(other.Post("/jobs/failed/retry"), 429, "a job is unfinished");
  EXPECT_EQ(own.service.store.job("failed")->state, db::JobState::failed);
  own.service.store.set_job_state("open", db::JobState::failed, "");
  EXPECT_EQ(other.Post("/jobs/failed/retry")->status, 200);
}

TEST_F(HttpServerTest, AJobOfTooManyParticlesIsRefused) {
  ServiceOptions few = options();
  few.limits.particles = 500;
  ServerOfItsOwn own{few};
  const auto answer = httplib::Client(own.site.url)
                          .Post("/processes/simulate-section/execution", tests::simulate_request(),
                                "application/json");
  expect_problem(answer, 400, "580 particles");
  EXPECT_EQ(own.service.store.count_jobs({}), 0);
}

TEST_F(HttpServerTest, AnErrorInsideTellsTheClientNothingOfIt) {
  db::RasterRecord lost;
  lost.id = lost.name = "lost";
  lost.file = "rasters/lost.tif";
  service.store.add_raster(lost);
  const auto answer = client.Get("/rasters/lost/hillshade.png");
  expect_problem(answer, 500, "a file that is not there");
  EXPECT_FALSE(answer->has_header("EXCEPTION_WHAT"));
  EXPECT_EQ(answer->body.find("lost.tif"), std::string::npos) << answer->body;
  EXPECT_EQ(answer->body.find(service.data.root().string()), std::string::npos) << answer->body;
}

TEST_F(HttpServerTest, RastersThatAreNoneAreRefusedAndLeaveNothing) {
  expect_problem(client.Post("/rasters?name=x", "", "image/tiff"), 400, "empty");
  expect_problem(client.Post("/rasters?name=x", "no raster", "image/tiff"), 400, "text");
  expect_problem(client.Post("/rasters?name=..%2Fx", "no raster", "image/tiff"), 400, "path");
  expect_problem(client.Post("/rasters", "no raster", "image/tiff"), 400, "no name");
  expect_problem(client.Post("/rasters?name=x&vertical_unit=km", "x", "image/tiff"), 400, "unit");
  EXPECT_TRUE(ok("/rasters")["rasters"].empty());
  EXPECT_TRUE(std::filesystem::is_empty(service.data.uploads()));
}

}  // namespace
}  // namespace leda::server
