#include "server/http/http_server.hpp"

#include <functional>
#include <set>
#include <thread>
#include <utility>
#include <vector>

#include "tests/server/http/http_fixture.hpp"
#include "tests/server/run_fixture.hpp"

namespace leda::server {
namespace {

TEST_F(HttpServerTest, TheLandingPageLinksWhatClientsLookFor) {
  std::set<std::string> relations;
  const json landing = ok("/");
  for (const auto& link : landing["links"]) relations.insert(link["rel"].get<std::string>());
  for (const char* rel : {"self", "service-desc", "conformance", "data",
                          "http://www.opengis.net/def/rel/ogc/1.0/processes",
                          "http://www.opengis.net/def/rel/ogc/1.0/job-list"}) {
    EXPECT_TRUE(relations.contains(rel)) << rel;
  }
  const auto page = client.Get("/", {{"Accept", "text/html,*/*"}});
  ASSERT_TRUE(page);
  EXPECT_EQ(page->get_header_value("Content-Type"), "text/html; charset=utf-8");
}

// QGIS drops the query of the data link and appends /ID and /ID/items to its path.
TEST_F(HttpServerTest, TheDataLinkIsThePathThatClientsBuildOn) {
  std::string data;
  const json landing = ok("/?f=json");
  for (const auto& link : landing["links"]) {
    if (link["rel"] == "data") data = link["href"];
  }
  EXPECT_EQ(data, site.url + "/collections");
  const json collections = ok("/collections");
  for (const auto& collection : collections["collections"]) {
    const std::string own = "/collections/" + collection["id"].get<std::string>();
    EXPECT_EQ(ok(own)["id"], collection["id"]);
    std::set<std::string> items;
    for (const auto& link : collection["links"]) {
      if (link["rel"] == "items") items.insert(link["href"].get<std::string>());
    }
    EXPECT_TRUE(items.contains(site.url + own + "/items")) << collection.dump(2);
    EXPECT_EQ(ok(own + "/items")["type"], "FeatureCollection");
  }
}

TEST_F(HttpServerTest, TheClassesItConformsToAreNamed) {
  std::set<std::string> classes;
  const json conformance = ok("/conformance");
  for (const auto& name : conformance["conformsTo"]) classes.insert(name.get<std::string>());
  for (const char* name :
       {"core", "ogc-process-description", "json", "oas30", "job-list", "dismiss"}) {
    EXPECT_TRUE(classes.contains(
        std::string("http://www.opengis.net/spec/ogcapi-processes-1/1.0/conf/") + name))
        << name;
  }
}

TEST_F(HttpServerTest, ProblemsOfTheStandardCarryItsTypes) {
  const std::string base = "http://www.opengis.net/def/exceptions/ogcapi-processes-1/1.0/";
  const auto type_at = [&](const std::string& path) {
    return json::parse(client.Get(path)->body)["type"].get<std::string>();
  };
  EXPECT_EQ(type_at("/processes/none"), base + "no-such-process");
  EXPECT_EQ(type_at("/jobs/none"), base + "no-such-job");
  db::JobRecord job;
  job.id = "open";
  job.process = "simulate-section";
  service.store.add_job(job);
  EXPECT_EQ(type_at("/jobs/open/results"), base + "result-not-ready");
  EXPECT_EQ(client.Get("/jobs/open/results")->status, 404);
}

TEST_F(HttpServerTest, ProcessesSayWhatTheyTakeAndGive) {
  for (const auto& [name, output] : std::vector<std::pair<std::string, std::string>>{
           {"map-region", "runout_zones"},
           {"simulate-section", "sections"},
           {"resolution-study", "fastest_within_wanted_error"},
           {"hindcast", "posterior"}}) {
    const json process = ok("/processes/" + name);
    EXPECT_EQ(process["jobControlOptions"], (json{"async-execute", "dismiss"})) << name;
    EXPECT_TRUE(process["outputs"].contains(output)) << name;
  }
}

TEST_F(HttpServerTest, TheInterfaceListsEveryPath) {
  const auto answer = client.Get("/api");
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->get_header_value("Content-Type"),
            "application/vnd.oai.openapi+json;version=3.0");
  const json api = json::parse(answer->body);
  EXPECT_EQ(api["openapi"], "3.0.3");
  EXPECT_EQ(api["servers"][0]["url"], site.url);
  EXPECT_TRUE(api["paths"]["/jobs/{jobID}"].contains("delete"));
  EXPECT_EQ(api["paths"]["/jobs/{jobID}"]["get"]["parameters"][0]["name"], "jobID");
  EXPECT_TRUE(api["paths"]["/rasters"]["post"].contains("requestBody"));
}

TEST_F(HttpServerTest, EveryReferenceOfAProcessResolves) {
  const json list = ok("/processes");
  EXPECT_EQ(list["processes"].size(), processes().size());
  for (const auto& process : list["processes"]) {
    const json document = ok("/processes/" + process["id"].get<std::string>());
    EXPECT_FALSE(document["inputs"].empty());
    std::function<void(const json&)> look = [&](const json& part) {
      if (part.is_object() && part.contains("$ref")) {
        const auto pointer = part["$ref"].get<std::string>().substr(1);
        EXPECT_TRUE(document.contains(json::json_pointer(pointer))) << pointer;
      }
      if (part.is_structured()) {
        for (const auto& inner : part) look(inner);
      }
    };
    look(document);
  }
}

TEST_F(HttpServerTest, AJobIsCommittedBeforeTheReply) {
  const auto answer = submit(tests::simulate_request());
  ASSERT_TRUE(answer);
  ASSERT_EQ(answer->status, 201) << answer->body;
  const json status = json::parse(answer->body);
  const std::string id = status["jobID"];
  EXPECT_EQ(answer->get_header_value("Location"), site.url + "/jobs/" + id);
  EXPECT_EQ(status["type"], "process");
  EXPECT_EQ(status["processID"], "simulate-section");
  EXPECT_EQ(ok("/jobs/" + id)["jobID"], id);
}

TEST_F(HttpServerTest, TheSameKeyGivesTheSameJob) {
  const auto first = submit(tests::simulate_request(), "key-1");
  const auto second = submit(tests::simulate_request(), "key-1");
  EXPECT_EQ(second->status, 201);
  EXPECT_EQ(first->get_header_value("Location"), second->get_header_value("Location"));
  expect_problem(submit(tests::simulate_request() + " ", "key-1"), 422, "other body");
  expect_problem(submit(tests::simulate_request(), "a%0d%0aSet-Cookie: x"), 400, "bad key");
  EXPECT_EQ(ok("/jobs")["numberMatched"], 1);
}

TEST_F(HttpServerTest, JobsArePagedAndFiltered) {
  for (int i = 0; i < 3; ++i) ASSERT_EQ(submit(tests::simulate_request())->status, 201);
  const json first = ok("/jobs?limit=2&processID=simulate-section&type=process");
  EXPECT_EQ(first["jobs"].size(), 2U);
  std::string next;
  for (const auto& link : first["links"]) {
    if (link["rel"] == "next") next = link["href"];
  }
  ASSERT_FALSE(next.empty());
  const json second = ok(next.substr(site.url.size()));
  EXPECT_EQ(second["jobs"].size(), 1U);
  EXPECT_EQ(ok("/jobs?processID=map-region")["numberMatched"], 0);
  EXPECT_EQ(ok("/jobs?type=other")["numberMatched"], 0);
  EXPECT_EQ(ok("/jobs?datetime=2000-01-01T00:00:00Z/2001-01-01T00:00:00Z")["numberMatched"], 0);
}

TEST_F(HttpServerTest, AFailedJobHasItsErrorForAResultAndMayBeRetried) {
  const std::string id = json::parse(submit(tests::simulate_request())->body)["jobID"];
  const std::string path = "/jobs/" + id;
  while (ok(path)["status"] != "failed") std::this_thread::sleep_for(std::chrono::milliseconds(20));
  expect_problem(client.Get(path + "/results"), 500, "results of a failed job");
  expect_problem(client.Get(path + "/export"), 500, "export of a failed job");
  const auto retried = client.Post(path + "/retry");
  ASSERT_TRUE(retried);
  EXPECT_EQ(retried->status, 200) << retried->body;
}

TEST_F(HttpServerTest, ADismissedJobStaysDismissed) {
  const std::string id = json::parse(submit(tests::simulate_request())->body)["jobID"];
  const auto answer = client.Delete("/jobs/" + id);
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->status, 200);
  EXPECT_EQ(json::parse(answer->body)["status"], "dismissed");
  expect_problem(client.Get("/jobs/" + id + "/results"), 404, "results");
  expect_problem(client.Post("/jobs/" + id + "/retry"), 409, "retry");
}

TEST_F(HttpServerTest, EventsTellTheStatusUntilTheEnd) {
  const std::string id = json::parse(submit(tests::simulate_request())->body)["jobID"];
  const auto answer = client.Get("/jobs/" + id + "/events");
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->get_header_value("Content-Type"), "text/event-stream");
  const auto last = answer->body.rfind("data: ");
  ASSERT_NE(last, std::string::npos);
  const json status = json::parse(answer->body.substr(last + 6));
  EXPECT_EQ(status["status"], "failed");
  const auto id_line = answer->body.rfind("id: ");
  const auto end_of_id = answer->body.find('\n', id_line);
  const std::string last_id = answer->body.substr(id_line + 4, end_of_id - id_line - 4);
  EXPECT_EQ(client.Get("/jobs/" + id + "/events", {{"Last-Event-ID", last_id}})->body, "");
}

TEST_F(HttpServerTest, MetricsCountRequestsByRoute) {
  ok("/healthz");
  client.Get("/jobs/some-id");
  const auto answer = client.Get("/metrics");
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->get_header_value("Content-Type"), "text/plain; version=0.0.4");
  EXPECT_NE(answer->body.find("route=\"/jobs/{jobID}\",status=\"404\""), std::string::npos);
  EXPECT_EQ(answer->body.find("some-id"), std::string::npos);
  EXPECT_NE(answer->body.find("leda_jobs{status=\"failed\"} 0"), std::string::npos);
}

TEST_F(HttpServerTest, MetricsTellOfTheQueueAndOfRuns) {
  service.metrics.count_run(tests::made_up_result());
  service.metrics.count_restarts(2);
  const std::string text = client.Get("/metrics")->body;
  for (const char* line :
       {"leda_queue_depth 0", "leda_run_seconds_count 1",
        "leda_ns_per_particle_step_bucket{le=\"50\"} 1", "leda_worker_restarts_total 2",
        "leda_results_total{status=\"at-rest\"} 1", "leda_now{what=\"runs\"} 0",
        "leda_build_info{version="}) {
    EXPECT_NE(text.find(line), std::string::npos) << line << "\n" << text;
  }
}

TEST_F(HttpServerTest, ADryRunIsAnsweredAtOnceAndStoresNothing) {
  json request = json::parse(tests::simulate_request());
  request["dryRun"] = true;
  const auto answer = submit(request.dump());
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->status, 200) << answer->body;
  EXPECT_EQ(json::parse(answer->body)["estimate"]["runs"], 1);
  EXPECT_EQ(ok("/jobs")["numberMatched"], 0);
  request["inputs"]["case"].erase("ground");
  expect_problem(submit(request.dump()), 400, "a dry run finds the same faults");
}

TEST_F(HttpServerTest, JobsAreFoundByTheTimeTheyTook) {
  const std::string id = json::parse(submit(tests::simulate_request())->body)["jobID"];
  while (ok("/jobs/" + id)["status"] != "failed") {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  EXPECT_EQ(ok("/jobs?maxDuration=600")["numberMatched"], 1);
  EXPECT_EQ(ok("/jobs?minDuration=600")["numberMatched"], 0);
}

TEST_F(HttpServerTest, ATagAmongSeveralOrAnyIsKnown) {
  const std::string id = json::parse(submit(tests::simulate_request())->body)["jobID"];
  service.dispatcher.dismiss(id);
  service.store.set_job_state(id, db::JobState::accepted, "");
  service.store.set_job_state(id, db::JobState::successful, "");
  const std::string path = "/jobs/" + id + "/results";
  const std::string tag = client.Get(path)->get_header_value("ETag");
  ASSERT_FALSE(tag.empty());
  for (const std::string& known : {tag, "\"x\", W/" + tag, std::string("*")}) {
    EXPECT_EQ(client.Get(path, {{"If-None-Match", known}})->status, 304) << known;
  }
  EXPECT_EQ(client.Get(path, {{"If-None-Match", "\"x\""}})->status, 200);
}

TEST(ListenAddress, OthersAreServedWithTokensAlone) {
  EXPECT_THROW(listen_address_from("10.0.0.7:80"), ListenError);
  EXPECT_EQ(listen_address_from("10.0.0.7:80", true).host, "10.0.0.7");
  EXPECT_EQ(listen_address_from("[::]:80", true).host, "::");
  EXPECT_THROW(listen_address_from(":80", true), ListenError);
}

TEST(ListenAddress, OnlyThisMachineIsServed) {
  EXPECT_EQ(listen_address_from("127.0.0.1:0").port, 0);
  EXPECT_EQ(listen_address_from("localhost:8080").host, "localhost");
  EXPECT_EQ(listen_address_from("[::1]:80").host, "::1");
  for (const char* text :
       {"0.0.0.0:80", "192.168.1.1:80", ":80", "127.0.0.1", "127.0.0.1:", "127.0.0.1:x",
        "127.0.0.1:70000", "127.0.0.1:-1", "[::]:80", "localhost.example.org:80"}) {
    EXPECT_THROW(listen_address_from(text), ListenError) << text;
  }
}

}  // namespace
}  // namespace leda::server
