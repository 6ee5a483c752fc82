#include <filesystem>
#include <nlohmann/json.hpp>

#include "server/http/handlers/handlers.hpp"
#include "server/http/site.hpp"

namespace leda::server {
namespace {

constexpr std::chrono::seconds longest_turn{120};
constexpr std::uintmax_t least_free_bytes = std::uintmax_t{200} << 20;

/// Why jobs cannot be run now; empty where they can.
std::string hindrance(const Site& site) {
  try {
    site.service.store.count_jobs({});
  } catch (const db::StoreError&) {
    return "the store does not answer";
  }
  if (site.service.dispatcher.since_last_turn() > longest_turn)
    return "the dispatcher does not turn";
  std::error_code error;
  const auto space = std::filesystem::space(site.service.data.root(), error);
  if (!error && space.available < least_free_bytes) return "the disk is almost full";
  return "";
}

}  // namespace

Answer get_healthz(Site& /*site*/, const Call& /*call*/) { return json_answer({{"status", "ok"}}); }

Answer get_readyz(Site& site, const Call& /*call*/) {
  const std::string reason = hindrance(site);
  if (reason.empty()) return json_answer({{"status", "ready"}});
  Answer answer = json_answer({{"status", "not ready"}, {"reason", reason}}, 503);
  answer.headers.emplace_back("Retry-After", "10");
  return answer;
}

Answer get_metrics(Site& site, const Call& /*call*/) {
  Answer answer;
  answer.type = "text/plain; version=0.0.4";
  Metrics::Now now;
  now.runs = site.service.dispatcher.running();
  now.streams = site.streams.taken();
  now.connections = site.connections();
  answer.body = site.service.metrics.text(site.service.store, now);
  return answer;
}

}  // namespace leda::server
