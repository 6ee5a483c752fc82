#include "server/run/interrupt_signals.hpp"

#include <gtest/gtest.h>

#include <csignal>

namespace leda::server {
namespace {

TEST(InterruptSignals, AreRememberedInsteadOfEndingTheProgram) {
  for (const int signal : {SIGTERM, SIGINT}) {
    const InterruptSignals signals;
    EXPECT_FALSE(InterruptSignals::arrived());
    std::raise(signal);
    EXPECT_TRUE(InterruptSignals::arrived());
  }
}

TEST(InterruptSignals, EarlierHandlersComeBack) {
  struct sigaction before {
  }, after{};
  sigaction(SIGTERM, nullptr, &before);
  { const InterruptSignals signals; }
  sigaction(SIGTERM, nullptr, &after);
  EXPECT_EQ(before.sa_handler, after.sa_handler);
}

}  // namespace
}  // namespace leda::server
