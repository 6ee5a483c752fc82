#include "server/documents/interrupt_signals.hpp"

#include <array>
#include <csignal>

namespace leda::server {
namespace {

constexpr std::array signals{SIGTERM, SIGINT};

volatile std::sig_atomic_t signal_arrived = 0;
std::array<struct sigaction, signals.size()> earlier{};

void remember(int) { signal_arrived = 1; }

}  // namespace

InterruptSignals::InterruptSignals() {
  signal_arrived = 0;
  struct sigaction action {};
  action.sa_handler = remember;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  for (std::size_t i = 0; i < signals.size(); ++i) sigaction(signals[i], &action, &earlier[i]);
}

InterruptSignals::~InterruptSignals() {
  for (std::size_t i = 0; i < signals.size(); ++i) sigaction(signals[i], &earlier[i], nullptr);
}

bool InterruptSignals::arrived() { return signal_arrived != 0; }

}  // namespace leda::server
