#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "server/http/handlers/handlers.hpp"
#include "server/http/handlers/job_document.hpp"
#include "server/http/site.hpp"
#include "server/operate/problem.hpp"

namespace leda::server {
namespace {

constexpr std::chrono::milliseconds between_looks{250};
constexpr std::chrono::seconds between_signs_of_life{15};

/// Follows a job. The id of an event is the time the job was updated and its status (two updates
/// may fall into one millisecond), so a client that comes back with Last-Event-ID hears only what
/// is new.
struct Follower {
  Site& site;
  std::string job;
  std::string last_id;
  bool done = false;
  std::chrono::steady_clock::time_point spoke = std::chrono::steady_clock::now();

  std::optional<std::string> next() {
    if (done) return std::nullopt;
    const auto record = site.service.store.job_status(job);
    if (!record) return std::nullopt;
    done = db::is_final(record->state);
    const auto now = std::chrono::steady_clock::now();
    const std::string id = record->updated + "/" + db::to_string(record->state);
    if (id != last_id) {
      last_id = id;
      spoke = now;
      return "id: " + last_id + "\nevent: status\ndata: " + status_info(*record, site.url).dump() +
             "\n\n";
    }
    if (done) return std::nullopt;
    std::this_thread::sleep_for(between_looks);
    if (now - spoke < between_signs_of_life) return "";
    spoke = now;
    return ": still there\n\n";
  }
};

}  // namespace

Answer get_events(Site& site, const Call& call) {
  const auto job = job_status_or_problem(site.service.store, call.captured[0]);
  auto slot = site.streams.take();
  if (!slot) {
    throw Problem(Failure::too_busy, "too many event streams are open: poll the job instead");
  }
  auto follower = std::make_shared<Follower>(Follower{site, job.id, call.header("Last-Event-ID")});
  Answer answer;
  answer.type = "text/event-stream";
  answer.headers.emplace_back("Cache-Control", "no-cache");
  answer.stream = [slot, follower] { return follower->next(); };
  return answer;
}

}  // namespace leda::server
