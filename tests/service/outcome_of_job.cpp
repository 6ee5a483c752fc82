#include "tests/service/outcome_of_job.hpp"

#include <sqlite3.h>

#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "db/result_file.hpp"

namespace leda::tests {
namespace {

using nlohmann::json;

std::string read_text(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

json geometries(const json& collection) {
  json all = json::array();
  for (const auto& feature : collection["features"]) {
    all.push_back({feature["geometry"], feature["properties"]["sections"],
                   feature["properties"]["largest_distance_m"]});
  }
  return all;
}

bool same_particles(const Frame& a, const Frame& b) {
  return a.time_s == b.time_s && a.x == b.x && a.z == b.z && a.velocity_x == b.velocity_x &&
         a.velocity_z == b.velocity_z && a.stress_xx == b.stress_xx && a.stress_zz == b.stress_zz &&
         a.stress_xz == b.stress_xz && a.stress_yy == b.stress_yy &&
         a.plastic_strain == b.plastic_strain && a.strength == b.strength && a.volume == b.volume &&
         a.material == b.material;
}

bool same_fields(const std::filesystem::path& one, const std::filesystem::path& other) {
  try {
    const auto a = db::read_result_file(one), b = db::read_result_file(other);
    bool same = a.size() == b.size() && !a.empty();
    for (std::size_t i = 0; same && i < a.size(); ++i) same = same_particles(a[i], b[i]);
    return same;
  } catch (const std::runtime_error&) {  // missing or damaged
    return false;
  }
}

/// The members of an ensemble without what each took; empty where there is none.
std::string members_of(LedaServer& server, const std::string& job) {
  const auto answer = server.client().Get("/jobs/" + job + "/members?f=csv");
  std::string members, line;
  if (!answer || answer->status != 200) return members;
  constexpr int run_time_from_behind = 3;  // before hash and version
  std::istringstream lines(answer->body);
  while (std::getline(lines, line)) {
    std::size_t end = line.size(), begin = end;
    for (int cell = 0; cell < run_time_from_behind; ++cell) {
      end = begin;
      begin = line.rfind(',', begin - 1);
    }
    members += line.erase(begin, end - begin) + "\n";
  }
  return members;
}

std::int64_t number_from(sqlite3* store, const char* query) {
  sqlite3_stmt* statement = nullptr;
  if (sqlite3_prepare_v2(store, query, -1, &statement, nullptr) != SQLITE_OK ||
      sqlite3_step(statement) != SQLITE_ROW) {
    throw std::runtime_error(std::string(query) + ": " + sqlite3_errmsg(store));
  }
  const std::int64_t number = sqlite3_column_int64(statement, 0);
  sqlite3_finalize(statement);
  return number;
}

}  // namespace

JobOutcome outcome_of(LedaServer& server, const std::filesystem::path& data,
                      const std::string& job) {
  JobOutcome outcome;
  const json results = server.get("/jobs/" + job + "/results");
  outcome.zones = {geometries(results["release_zones"]), geometries(results["runout_zones"]),
                   geometries(results["probability_zones"])};
  outcome.members = members_of(server, job);
  for (const auto& section : results["sections"]) {
    const std::string name = section["name"];
    const auto folder = data / "runs" / section["run"].get<std::string>();
    json result = json::parse(read_text(folder / "result.json"), nullptr, false);
    if (result.is_object()) {
      result.erase("run_time_s");
      result.erase("ns_per_particle_step");
    }
    outcome.results[name] = result;
    outcome.profiles[name] = read_text(folder / "profile_after.csv");
    outcome.folders[name] = folder;
  }
  return outcome;
}

std::vector<std::string> differences(const JobOutcome& one, const JobOutcome& other) {
  std::vector<std::string> found;
  if (one.results.size() != other.results.size()) found.emplace_back("the number of sections");
  if (one.zones != other.zones) found.emplace_back("the zones");
  if (one.members != other.members) found.emplace_back("the members");
  for (const auto& [name, result] : one.results) {
    const auto same = other.results.find(name);
    if (same == other.results.end()) {
      found.push_back(name + " is missing");
      continue;
    }
    if (result != same->second) found.push_back(name + ": result.json");
    if (one.profiles.at(name) != other.profiles.at(name)) {
      found.push_back(name + ": profile_after.csv");
    }
    if (!same_fields(one.folders.at(name) / "fields.h5", other.folders.at(name) / "fields.h5")) {
      found.push_back(name + ": fields.h5");
    }
  }
  return found;
}

std::vector<std::string> faults_of_store(const std::filesystem::path& file) {
  struct Question {
    const char* what;
    const char* query;
    std::int64_t wanted;
  };
  constexpr Question questions[] = {
      {"jobs", "SELECT count(*) FROM jobs", 1},
      {"sections without exactly one result",
       "SELECT count(*) FROM sections WHERE "
       "(SELECT count(*) FROM results WHERE section_id = sections.id) <> 1",
       0},
      {"sections that are not finished", "SELECT count(*) FROM sections WHERE state <> 'finished'",
       0},
      {"results that are not of their section's latest run",
       "SELECT count(*) FROM results WHERE run_id NOT IN (SELECT latest_run_id FROM sections)", 0},
      {"runs under way", "SELECT count(*) FROM runs WHERE outcome IS NULL", 0}};
  sqlite3* store = nullptr;
  if (sqlite3_open_v2(file.c_str(), &store, SQLITE_OPEN_READONLY, nullptr) != SQLITE_OK) {
    sqlite3_close(store);
    throw std::runtime_error(file.string() + " cannot be opened");
  }
  std::vector<std::string> faults;
  for (const auto& question : questions) {
    const std::int64_t number = number_from(store, question.query);
    if (number != question.wanted) {
      faults.push_back(std::string(question.what) + ": " + std::to_string(number));
    }
  }
  sqlite3_close(store);
  return faults;
}

}  // namespace leda::tests
