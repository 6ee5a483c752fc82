#include <filesystem>
#include <nlohmann/json.hpp>

#include "server/http/handlers/handlers.hpp"
#include "server/jobs/service.hpp"

namespace leda::server {
namespace {

constexpr std::chrono::seconds longest_turn{120};
constexpr std::uintmax_t least_free_bytes = std::uintmax_t{200} << 20;

/// Why jobs cannot be run now; empty where they can.
std::string hindrance(const Service& service) {
  try {
    service.store.count_jobs({});
  } catch (const db::StoreError&) {
    return "the store does not answer";
  }
  if (service.dispatcher.since_last_turn() > longest_turn) return "the dispatcher does not turn";
  std::error_code error;
  const auto space = std::filesystem::space(service.data.root(), error);
  if (!error && space.available < least_free_bytes) return "the disk is almost full";
  return "";
}

}  // namespace

Answer get_healthz(Service& /*service*/, const Call& /*call*/) {
  return json_answer({{"status", "ok"}});
}

Answer get_readyz(Service& service, const Call& /*call*/) {
  const std::string reason = hindrance(service);
  if (reason.empty()) return json_answer({{"status", "ready"}});
  Answer answer = json_answer({{"status", "not ready"}, {"reason", reason}}, 503);
  answer.headers.emplace_back("Retry-After", "10");
  return answer;
}

Answer get_metrics(Service& service, const Call& /*call*/) {
  Answer answer;
  answer.type = "text/plain; version=0.0.4";
  Metrics::Now now;
  now.runs = service.dispatcher.running();
  now.streams = static_cast<std::size_t>(service.streams.load());
  now.connections = service.connections();
  answer.body = service.metrics.text(service.store, now);
  return answer;
}

}  // namespace leda::server
