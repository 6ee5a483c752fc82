#pragma once

namespace leda::server {

/// While one of these lives, SIGTERM and SIGINT do not end the program: they are remembered.
/// Only one at a time.
class InterruptSignals {
 public:
  InterruptSignals();
  ~InterruptSignals();
  InterruptSignals(const InterruptSignals&) = delete;
  InterruptSignals& operator=(const InterruptSignals&) = delete;

  static bool arrived();
};

}  // namespace leda::server
