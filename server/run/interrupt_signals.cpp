#include "server/run/interrupt_signals.hpp"

namespace leda::server {
namespace {

volatile std::sig_atomic_t& signal_arrived() {
  static volatile std::sig_atomic_t flag = 0;
  return flag;
}

void remember(int /*signal*/) { signal_arrived() = 1; }

}  // namespace

InterruptSignals::InterruptSignals() {
  signal_arrived() = 0;
  struct sigaction action {};
  action.sa_handler = remember;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  for (std::size_t i = 0; i < signals.size(); ++i) sigaction(signals[i], &action, &earlier_[i]);
}

InterruptSignals::~InterruptSignals() {
  for (std::size_t i = 0; i < signals.size(); ++i) sigaction(signals[i], &earlier_[i], nullptr);
}

bool InterruptSignals::arrived() { return signal_arrived() != 0; }

}  // namespace leda::server
