#include "db/utc_now.hpp"

#include <gtest/gtest.h>

namespace leda::db {
namespace {

TEST(UtcNow, ATimeIsWrittenToTheMillisecondThatHasBegun) {
  using namespace std::chrono_literals;
  const std::chrono::system_clock::time_point epoch;
  EXPECT_EQ(utc_text(epoch), "1970-01-01T00:00:00.000Z");
  EXPECT_EQ(utc_text(epoch + 86'400s + 1999us), "1970-01-02T00:00:00.001Z");
  EXPECT_EQ(utc_text(epoch + 1'769'860'800s + 999'999us), "2026-01-31T12:00:00.999Z");
  EXPECT_LE(utc_text(std::chrono::system_clock::now() - 1h), utc_now());
}

}  // namespace
}  // namespace leda::db
