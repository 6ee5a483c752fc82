#include "server/commands/progress_line.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <thread>

namespace leda::server {
namespace {

using namespace std::chrono_literals;

/// What is written to standard error, which is no terminal then.
std::string written(const std::function<void()>& by) {
  testing::internal::CaptureStderr();
  by();
  return testing::internal::GetCapturedStderr();
}

TEST(ProgressLine, WhereThereIsNoTerminalLinesComeNowAndThen) {
  const std::string text = written([] {
    ProgressLine line(false, 30ms);
    line.show("too soon");
    std::this_thread::sleep_for(40ms);
    line.show("10 %");
    line.show("20 %");
    std::this_thread::sleep_for(40ms);
    line.show("10 %");
    line.show("30 %");
    line.end();
  });
  EXPECT_EQ(text, "10 %\n30 %\n") << "what was told already is not told again";
}

TEST(ProgressLine, ASilentOneSaysNothing) {
  EXPECT_EQ(written([] {
              ProgressLine line(true, 0ms);
              line.show("10 %");
              line.end();
            }),
            "");
}

}  // namespace
}  // namespace leda::server
