#include "server/operate/metrics.hpp"

#include <prometheus/text_serializer.h>

#include "server/operate/version.hpp"

namespace leda::server {

namespace {

using Bounds = prometheus::Histogram::BucketBoundaries;

prometheus::Family<prometheus::Gauge>& gauges(prometheus::Registry& registry, const char* name,
                                              const char* help) {
  return prometheus::BuildGauge().Name(name).Help(help).Register(registry);
}

prometheus::Family<prometheus::Counter>& counters(prometheus::Registry& registry, const char* name,
                                                  const char* help) {
  return prometheus::BuildCounter().Name(name).Help(help).Register(registry);
}

prometheus::Family<prometheus::Histogram>& histograms(prometheus::Registry& registry,
                                                      const char* name, const char* help) {
  return prometheus::BuildHistogram().Name(name).Help(help).Register(registry);
}

}  // namespace

Metrics::Metrics()
    : registry_(std::make_shared<prometheus::Registry>()),
      requests_(counters(*registry_, "leda_http_requests_total", "HTTP requests answered")),
      durations_(
          histograms(*registry_, "leda_http_request_seconds", "Time from a request to its answer")),
      jobs_(gauges(*registry_, "leda_jobs", "Jobs in the store by status")),
      now_(gauges(*registry_, "leda_now", "Runs, event streams and connections now")),
      queue_(gauges(*registry_, "leda_queue_depth", "Sections that wait for a run").Add({})),
      results_(counters(*registry_, "leda_results_total", "Results taken in by status")),
      run_seconds_(histograms(*registry_, "leda_run_seconds", "Time that runs took")
                       .Add({}, Bounds{1, 3, 10, 30, 100, 300, 1000, 3000, 10'000})),
      pace_(histograms(*registry_, "leda_ns_per_particle_step",
                       "Time of a run over its particles and steps, ns")
                .Add({}, Bounds{5, 10, 20, 30, 40, 50, 60, 80, 100, 150, 300})),
      restarts_(counters(*registry_, "leda_worker_restarts_total",
                         "Runs that were cut off and started once more")
                    .Add({})) {
  gauges(*registry_, "leda_build_info", "Version of Leda").Add({{"version", version()}}).Set(1);
}

void Metrics::count_request(const std::string& method, const std::string& route, int status,
                            double seconds) {
  requests_.Add({{"method", method}, {"route", route}, {"status", std::to_string(status)}})
      .Increment();
  const prometheus::Histogram::BucketBoundaries bounds{0.005, 0.02, 0.1, 0.5, 2, 10, 60};
  durations_.Add({{"route", route}}, bounds).Observe(seconds);
}

void Metrics::count_run(const SectionResult& result) {
  results_.Add({{"status", to_string(result.status)}}).Increment();
  run_seconds_.Observe(result.run_time_s);
  if (result.ns_per_particle_step > 0) pace_.Observe(result.ns_per_particle_step);
}

void Metrics::count_restarts(int runs) { restarts_.Increment(runs); }

std::string Metrics::text(const db::Store& store, const Now& now) {
  for (const auto state : {db::JobState::accepted, db::JobState::running, db::JobState::successful,
                           db::JobState::failed, db::JobState::dismissed}) {
    db::JobFilter filter;
    filter.states = {state};
    jobs_.Add({{"status", db::to_string(state)}}).Set(store.count_jobs(filter));
  }
  queue_.Set(store.count_sections(db::SectionState::waiting));
  now_.Add({{"what", "runs"}}).Set(static_cast<double>(now.runs));
  now_.Add({{"what", "streams"}}).Set(static_cast<double>(now.streams));
  now_.Add({{"what", "connections"}}).Set(static_cast<double>(now.connections));
  return prometheus::TextSerializer().Serialize(registry_->Collect());
}

}  // namespace leda::server
