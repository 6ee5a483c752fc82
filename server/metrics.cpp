#include "server/metrics.hpp"

#include <prometheus/text_serializer.h>

namespace leda::server {

Metrics::Metrics()
    : registry_(std::make_shared<prometheus::Registry>()),
      requests_(prometheus::BuildCounter()
                    .Name("leda_http_requests_total")
                    .Help("HTTP requests answered")
                    .Register(*registry_)),
      durations_(prometheus::BuildHistogram()
                     .Name("leda_http_request_seconds")
                     .Help("Time from a request to its answer")
                     .Register(*registry_)),
      jobs_(prometheus::BuildGauge()
                .Name("leda_jobs")
                .Help("Jobs in the store by status")
                .Register(*registry_)),
      runs_(prometheus::BuildGauge()
                .Name("leda_runs")
                .Help("Runs going on now")
                .Register(*registry_)
                .Add({})) {}

void Metrics::count_request(const std::string& method, const std::string& route, int status,
                            double seconds) {
  requests_.Add({{"method", method}, {"route", route}, {"status", std::to_string(status)}})
      .Increment();
  const prometheus::Histogram::BucketBoundaries bounds{0.005, 0.02, 0.1, 0.5, 2, 10, 60};
  durations_.Add({{"route", route}}, bounds).Observe(seconds);
}

std::string Metrics::text(const db::Store& store, std::size_t runs) {
  for (const auto state : {db::JobState::accepted, db::JobState::running, db::JobState::successful,
                           db::JobState::failed, db::JobState::dismissed}) {
    db::JobFilter filter;
    filter.states = {state};
    jobs_.Add({{"status", db::to_string(state)}}).Set(store.count_jobs(filter));
  }
  runs_.Set(static_cast<double>(runs));
  return prometheus::TextSerializer().Serialize(registry_->Collect());
}

}  // namespace leda::server
