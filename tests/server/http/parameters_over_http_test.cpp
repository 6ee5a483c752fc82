// What clients send beside the path: parameters, days, encodings, methods.

#include <map>

#include "server/http/routes.hpp"
#include "tests/db/samples.hpp"
#include "tests/server/http/http_fixture.hpp"

namespace leda::server {
namespace {

/// A job that is done, on a DEM, with a section.
class Parameterized : public HttpServerTest {
 protected:
  void SetUp() override {
    service.store.add_raster(db::samples::raster());
    db::JobRecord job = db::samples::job("done");
    job.created = "2026-01-31T12:30:00.000Z";
    job.state = db::JobState::successful;
    job.raster = db::samples::raster().id;
    service.store.add_job(job);
    service.store.set_sections("done", db::samples::layout(1));
  }

  int jobs_at(const std::string& datetime) {
    return ok("/jobs?datetime=" + datetime)["numberMatched"];
  }

  /// A path of a route that leads somewhere.
  static std::string path_of(const Route& route) {
    std::string path(route.path);
    const std::map<std::string, std::string> captured = {
        {"{jobID}", "done"},           {"{name}", "S1"},
        {"{rasterID}", "valley"},      {"{featureID}", "1"},
        {"{processID}", "map-region"}, {"{collectionID}", "sections"}};
    for (const auto& [name, value] : captured) {
      const auto at = path.find(name);
      if (at != std::string::npos) path.replace(at, name.size(), value);
    }
    return path;
  }

  httplib::Result ask(const Route& route, const std::string& query) {
    const std::string path = path_of(route) + "?" + query;
    if (route.method == "POST") return client.Post(path, "x", "application/octet-stream");
    if (route.method == "DELETE") return client.Delete(path);
    return client.Get(path);
  }
};

/// "f limit cursor" as a list.
std::vector<std::string> names_of(std::string_view parameters) {
  std::vector<std::string> names;
  std::istringstream words{std::string(parameters)};
  for (std::string name; words >> name;) names.push_back(name);
  return names;
}

TEST_F(Parameterized, EveryParameterThatIsKnownIsRead) {
  int tried = 0;
  for (const Route& route : routes()) {
    for (const std::string& name : names_of(route.parameters)) {
      // Jobs may be of a process that is no more, or of a type that is not here.
      if (name == "processID" || name == "type") continue;
      const auto answer = ask(route, name + "=no%20such%20value!");
      ASSERT_TRUE(answer);
      const bool refused = answer->status == 400 || (name == "job" && answer->status == 404);
      EXPECT_TRUE(refused) << route.method << " " << route.path << " " << name << ": "
                           << answer->status << " " << answer->body;
      ++tried;
    }
  }
  EXPECT_GT(tried, 30);
}

TEST_F(Parameterized, NoParameterIsGivenTwice) {
  for (const Route& route : routes()) {
    const auto names = names_of(route.parameters);
    if (names.empty()) continue;
    // In other words: cpp-httplib drops a pair that stands there twice, which says nothing twofold.
    const auto answer = ask(route, names[0] + "=json&" + names[0] + "=html");
    expect_problem(answer, 400, std::string(route.path));
    EXPECT_NE(answer->body.find("given more than once: " + names[0]), std::string::npos)
        << answer->body;
  }
  EXPECT_EQ(ok("/jobs?status=successful,failed")["numberMatched"], 1);
}

TEST_F(Parameterized, ADayIsTheWholeOfIt) {
  for (const char* day : {"2026-01-31", "2026-01-31/2026-01-31", "../2026-01-31", "2026-01-31/..",
                          "2026-01-30/2026-02-01", "/2026-01-31", "2026-01-31T12:30:00Z",
                          "2026-01-31T12:30:00Z/2026-01-31"}) {
    EXPECT_EQ(jobs_at(day), 1) << day;
  }
  for (const char* day : {"2026-01-30", "2026-02-01", "../2026-01-30", "2026-02-01/..",
                          "2026-01-31/2026-01-31T12:29:59Z"}) {
    EXPECT_EQ(jobs_at(day), 0) << day;
  }
  for (const char* bad : {"", "..", "today", "2026-01-31/today", "2026-13-01"}) {
    EXPECT_EQ(client.Get(std::string("/jobs?datetime=") + bad)->status, 400) << bad;
    EXPECT_EQ(client.Get(std::string("/collections/sections/items?datetime=") + bad)->status, 400)
        << bad;
  }
}

TEST_F(Parameterized, ProcessesComeInPages) {
  std::vector<std::string> seen;
  std::string path = "/processes?limit=2";
  while (!path.empty()) {
    const json page = ok(path);
    EXPECT_LE(page["processes"].size(), 2U);
    for (const auto& process : page["processes"]) seen.push_back(process["id"]);
    path.clear();
    for (const auto& link : page["links"]) {
      if (link["rel"] == "next") path = link["href"].get<std::string>().substr(site.url.size());
    }
    ASSERT_LE(seen.size(), processes().size());
  }
  EXPECT_EQ(seen.size(), processes().size());
}

TEST_F(Parameterized, ASlashTooManyIsToldWithThePathThatThereIs) {
  const auto answer = client.Get("/jobs/");
  expect_problem(answer, 404, "/jobs/");
  EXPECT_NE(answer->body.find("without the slash at its end there is, /jobs"), std::string::npos)
      << answer->body;
  EXPECT_EQ(client.Get("/nothing/")->body.find("slash"), std::string::npos);
}

TEST_F(Parameterized, AllowNamesEveryMethodThatWorks) {
  const auto answer = client.Put("/rasters", "x", "text/plain");
  expect_problem(answer, 405, "PUT");
  EXPECT_EQ(answer->get_header_value("Allow"), "POST, GET, HEAD, OPTIONS");
  const auto options = client.Options("/rasters");
  EXPECT_EQ(options->status, 204);
  EXPECT_EQ(options->get_header_value("Allow"), "POST, GET, HEAD, OPTIONS");
  EXPECT_EQ(client.Head("/rasters")->status, 200);
  EXPECT_EQ(client.Options("/nothing")->status, 404);
}

TEST_F(Parameterized, ARasterTellsWhatItHoldsIsRenamedAndRemoved) {
  const auto raster = ok("/rasters/valley");
  EXPECT_EQ(raster["lowest_m"], 3.25);
  EXPECT_EQ(raster["highest_m"], 51);
  EXPECT_EQ(raster["share_without_data"], 0.125);
  EXPECT_EQ(raster["cell_on_ground_m"], (json{0.9999, 1.4999}));
  EXPECT_EQ(raster["undeclared_fill_m"], 0);
  EXPECT_EQ(raster["warnings"], (json{"a piece of zeros"}));
  EXPECT_EQ(ok("/rasters")["rasters"][0], raster);

  const auto patch = [&](const char* body) {
    return client.Patch("/rasters/valley", body, "application/json");
  };
  expect_problem(patch(R"({"name": "../x"})"), 400, "no name for a raster");
  expect_problem(patch(R"({"title": "hill"})"), 400, "an unknown member");
  expect_problem(patch("hill"), 400, "no JSON");
  const auto renamed = patch(R"({"name": "hill"})");
  ASSERT_EQ(renamed->status, 200) << renamed->body;
  EXPECT_EQ(json::parse(renamed->body)["name"], "hill");
  expect_problem(client.Patch("/rasters/valley", R"({"name": "x"})", "application/json"), 404,
                 "the old name");

  db::JobRecord job = db::samples::job("going");
  job.raster = db::samples::raster().id;
  service.store.add_job(job);
  expect_problem(client.Delete("/rasters/hill"), 409, "an unfinished job stands on it");
  service.store.set_job_state("going", db::JobState::dismissed, "");
  EXPECT_EQ(client.Delete("/rasters/hill")->status, 204);
  expect_problem(client.Get("/rasters/hill"), 404, "removed");
  EXPECT_TRUE(ok("/rasters")["rasters"].empty());
  EXPECT_EQ(ok("/collections/sections/items")["numberMatched"], 1) << "of a finished job";
  const auto retried = client.Post("/jobs/done/retry");
  expect_problem(retried, 409, "its DEM is gone");
  EXPECT_NE(retried->body.find("register it again first"), std::string::npos) << retried->body;
}

TEST_F(Parameterized, ABodyInAnEncodingThatIsNotSpokenIsRefused) {
  const auto post = [&](const httplib::Headers& headers, const char* type) {
    return client.Post("/processes/simulate-section/execution", headers, "{}", type);
  };
  for (const char* encoding : {"zstd", "compress", "gzip, br", "x"}) {
    const auto answer = post({{"Content-Encoding", encoding}}, "application/json");
    expect_problem(answer, 415, encoding);
    EXPECT_NE(answer->body.find("gzip, deflate or br"), std::string::npos) << answer->body;
  }
  for (const char* type :
       {"application/json; charset=utf-16", "application/json;charset=\"latin1\""})
    expect_problem(post({}, type), 415, type);
  for (const char* type : {"application/json", "application/json; charset=UTF-8", "text/plain"}) {
    expect_problem(post({{"Content-Encoding", "identity"}}, type), 400, "faults of the document");
  }
}

}  // namespace
}  // namespace leda::server
