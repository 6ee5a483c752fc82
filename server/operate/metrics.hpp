#pragma once
// What /metrics tells, in the Prometheus text format 0.0.4.

#include <prometheus/counter.h>
#include <prometheus/family.h>
#include <prometheus/gauge.h>
#include <prometheus/histogram.h>
#include <prometheus/registry.h>

#include <memory>
#include <string>

#include "db/store.hpp"

namespace leda::server {

class Metrics {
 public:
  Metrics();
  /// @param route the route's pattern, never the path as sent: that would make a series a request
  void count_request(const std::string& method, const std::string& route, int status,
                     double seconds);
  /// A run that was taken in.
  void count_run(const SectionResult& result);
  /// Runs that were cut off and are started once more.
  void count_restarts(int runs);
  /// What is open or going on now.
  struct Now {
    std::size_t runs = 0, streams = 0, connections = 0;
  };
  std::string text(const db::Store& store, const Now& now);

 private:
  std::shared_ptr<prometheus::Registry> registry_;
  prometheus::Family<prometheus::Counter>& requests_;
  prometheus::Family<prometheus::Histogram>& durations_;
  prometheus::Family<prometheus::Gauge>& jobs_;
  prometheus::Family<prometheus::Gauge>& now_;
  prometheus::Gauge& queue_;
  prometheus::Family<prometheus::Counter>& results_;
  prometheus::Histogram& run_seconds_;
  prometheus::Histogram& pace_;
  prometheus::Counter& restarts_;
};

}  // namespace leda::server
