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
  std::string text(const db::Store& store, std::size_t runs);

 private:
  std::shared_ptr<prometheus::Registry> registry_;
  prometheus::Family<prometheus::Counter>& requests_;
  prometheus::Family<prometheus::Histogram>& durations_;
  prometheus::Family<prometheus::Gauge>& jobs_;
  prometheus::Gauge& runs_;
};

}  // namespace leda::server
