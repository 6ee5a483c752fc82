#include <nlohmann/json.hpp>

#include "server/handlers/handlers.hpp"
#include "server/service.hpp"

namespace leda::server {

Answer get_healthz(Service&, const Call&) { return json_answer({{"status", "ok"}}); }

Answer get_readyz(Service& service, const Call&) {
  const int jobs = service.store.count_jobs({});
  return json_answer({{"status", "ready"}, {"jobs", jobs}});
}

Answer get_metrics(Service& service, const Call&) {
  Answer answer;
  answer.type = "text/plain; version=0.0.4";
  answer.body = service.metrics.text(service.store, service.dispatcher.running());
  return answer;
}

}  // namespace leda::server
