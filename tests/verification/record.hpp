#pragma once
// What a test with a known answer found, for the table of tests/verification/README.md.

#include <gtest/gtest.h>

#include <sstream>

namespace leda::test {

/// Keeps the parts, put together with three digits a number, as the property "measured" of the test
/// that runs; measure.sh collects them. A second call replaces the first.
template <typename... Parts>
void record(const Parts&... parts) {
  std::ostringstream text;
  text.precision(3);
  (text << ... << parts);
  testing::Test::RecordProperty("measured", text.str());
}

}  // namespace leda::test
