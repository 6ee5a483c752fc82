#pragma once

#include <array>
#include <csignal>

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

 private:
  static constexpr std::array signals{SIGTERM, SIGINT};
  std::array<struct sigaction, signals.size()> earlier_{};
};

}  // namespace leda::server
