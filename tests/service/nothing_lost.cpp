// Nothing lost: a job of many short sections is computed once in peace, and once while its server
// and its workers are killed, the disk is full, results are damaged and the store is held by
// another program. At the end every section has exactly one result, and both say the same.

#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>

#include "tests/server/temporary_folder.hpp"
#include "tests/service/disturber.hpp"
#include "tests/service/outcome_of_job.hpp"
#include "tests/service/region_on_a_bank.hpp"

namespace leda::tests {
namespace {

using nlohmann::json;
using Clock = std::chrono::steady_clock;

struct Wanted {
  int sections = 300;
  int kills = 110;
  int others = 3;   ///< full disks, damaged results and held stores, each
  int members = 0;  ///< of each section; 0: no ensemble
  unsigned seed = 1;
  bool mount = true;
};

constexpr int skipped = 77;
const std::vector<std::string> serve_options{"--workers", "2"};

json ensemble_of(int members) {
  return {{"inputs",
           {{{"name", "su"},
             {"path", "/soil/materials/*/peak_strength_kPa"},
             {"apply", "scale"},
             {"distribution", {{"type", "uniform"}, {"min", 0.8}, {"max", 1.2}}}}}},
          {"sampling", {{"replicates", 4}}},
          {"stop", {{"min_members", members}, {"max_members", members}, {"half_width", 0.01}}}};
}

json region_of(int sections, int members) {
  json region = bank_region();
  if (members > 0) region["inputs"]["ensemble"] = ensemble_of(members);
  auto& inputs = region["inputs"];
  constexpr double south = 5113020, length_m = 360;
  inputs["sections"] = json::array({{{"along", {{380300, south}, {380300, south + length_m}}},
                                     {"spacing_m", length_m / (sections - 0.5)},
                                     {"upslope_m", 100},
                                     {"downslope_m", 80}}});
  return region;
}

std::string submit(LedaServer& server, const std::filesystem::path& dem, const json& region) {
  std::ifstream file(dem, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  server.client().Post(std::string("/rasters") + bank_query, bytes, "image/tiff");
  const auto answer =
      server.client().Post("/processes/map-region/execution", region.dump(), "application/json");
  if (!answer || answer->status != 201) {
    throw std::runtime_error("the job was not accepted: " + (answer ? answer->body : ""));
  }
  return json::parse(answer->body)["jobID"];
}

bool is_finished(LedaServer& server, const std::string& job) {
  const auto status = server.get("/jobs/" + job)["status"];
  return status != "accepted" && status != "running";
}

/// Runs in whose log a line says something.
int runs_that_say(const std::filesystem::path& data, const std::string& what) {
  int runs = 0;
  for (const auto& run : std::filesystem::directory_iterator(data / "runs")) {
    std::ifstream in(run.path() / "log.txt");
    const std::string log{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    runs += log.find(what) != std::string::npos ? 1 : 0;
  }
  return runs;
}

/// In turn a full disk, a damaged result and a held store. False where there was none to damage.
bool disturb_otherwise(Disturber& disturber, int turn) {
  if (turn % 3 == 0) {
    disturber.fill_disk();
  } else if (turn % 3 == 2) {
    disturber.hold_store();
  } else {
    const int before = disturber.done().corrupt_results;
    disturber.corrupt_result();
    return disturber.done().corrupt_results > before;
  }
  return true;
}

void disturb(Disturber& disturber, const std::string& job, const Wanted& wanted) {
  const int between = std::max(1, wanted.kills / (3 * wanted.others + 1));
  for (int next = between, turn = 0; !is_finished(disturber.server(), job);) {
    disturber.wait();
    if (disturber.done().kills() < wanted.kills) disturber.kill_any();
    if (disturber.done().kills() < next || turn >= 3 * wanted.others) continue;
    if (!disturb_otherwise(disturber, turn)) continue;  // not at hand now: again after a kill
    next += between;
    ++turn;
  }
}

int run(const Wanted& wanted) {
  // So often that a short run has some checkpoints.
  setenv("LEDA_CHECKPOINT_INTERVAL_S", "0.1", 1);
  const TemporaryFolder folder;
  SmallDisk disk(folder.path() / "disturbed", wanted.mount ? 1000 : 0);
  if (wanted.mount && !disk.is_mounted()) {
    std::cerr << "skipped: no small disk can be mounted here: --no-mount does without\n";
    return skipped;
  }
  const auto dem = folder.path() / "bank.asc";
  write_wavy_bank(dem);
  const json region = region_of(wanted.sections, wanted.members);

  auto begin = Clock::now();
  const auto quiet_data = folder.path() / "quiet";
  LedaServer quiet(quiet_data, serve_options);
  const std::string quiet_job = submit(quiet, dem, region);
  quiet.wait_for_job(quiet_job, std::chrono::hours(2));
  const JobOutcome expected = outcome_of(quiet, quiet_data, quiet_job);
  quiet.end();
  const double quiet_s = std::chrono::duration<double>(Clock::now() - begin).count();

  begin = Clock::now();
  const auto data = disk.folder();
  Disturber disturber(
      disk, [&] { return std::make_unique<LedaServer>(data, serve_options); }, wanted.seed);
  const std::string job = submit(disturber.server(), dem, region);
  disturb(disturber, job, wanted);
  const JobOutcome found = outcome_of(disturber.server(), data, job);
  disturber.server().end();
  const double disturbed_s = std::chrono::duration<double>(Clock::now() - begin).count();

  auto faults = differences(expected, found);
  for (auto& fault : faults_of_store(data / "leda.sqlite")) faults.push_back(std::move(fault));
  const auto& done = disturber.done();
  if (done.kills() < wanted.kills) {
    faults.push_back("the job was done after " + std::to_string(done.kills()) +
                     " kills: take more sections");
  }
  if (std::min({done.full_disks, done.corrupt_results, done.held_stores}) < wanted.others) {
    faults.push_back("the job was done before all other disturbances: take more sections");
  }
  std::cout << json{{"sections", expected.results.size()},
                    {"members", wanted.members},
                    {"server_kills", done.server_kills},
                    {"worker_kills", done.worker_kills},
                    {"full_disks", done.full_disks},
                    {"full_disk_by", disk.is_mounted() ? "tmpfs" : "limit on the size of files"},
                    {"damaged_results", done.corrupt_results},
                    {"store_held", done.held_stores},
                    {"runs_from_a_checkpoint", runs_that_say(data, "goes on from its checkpoint")},
                    {"checkpoints_refused", runs_that_say(data, "refused")},
                    {"undisturbed_s", quiet_s},
                    {"disturbed_s", disturbed_s},
                    {"faults", faults}}
                   .dump(2)
            << std::endl;
  return faults.empty() ? 0 : 1;
}

}  // namespace
}  // namespace leda::tests

int main(int argc, char** argv) {
  leda::tests::Wanted wanted;
  const std::vector<std::string> words(argv + 1, argv + argc);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto value = [&] { return i + 1 < words.size() ? std::stoi(words[++i]) : 0; };
    if (words[i] == "--sections") {
      wanted.sections = value();
    } else if (words[i] == "--kills") {
      wanted.kills = value();
    } else if (words[i] == "--members") {
      wanted.members = value();
    } else if (words[i] == "--others") {
      wanted.others = value();
    } else if (words[i] == "--seed") {
      wanted.seed = static_cast<unsigned>(value());
    } else if (words[i] == "--no-mount") {
      wanted.mount = false;
    } else {
      std::cerr << "nothing_lost [--sections N] [--members N] [--kills N] [--others N] [--seed N] "
                   "[--no-mount]\n";
      return 2;
    }
  }
  try {
    return leda::tests::run(wanted);
  } catch (const std::exception& error) {
    std::cerr << "error: " << error.what() << std::endl;
    return 1;
  }
}
