#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <ostream>

#include "solver/extremes/suite.hpp"
#include "solver/extremes/try_case.hpp"

namespace leda::solver {

void PrintTo(const ExtremeCase& extreme, std::ostream* out) { *out << extreme.extreme; }

}  // namespace leda::solver

namespace leda::solver::test {
namespace {

std::string as_test_name(std::string name) {
  std::ranges::replace_if(
      name, [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

class QuickSuite : public testing::TestWithParam<ExtremeCase> {};

TEST_P(QuickSuite, KeepsItsPromise) {
  const ExtremeCase& extreme = GetParam();
  std::vector<Outcome> before;
  for (const ExtremeCase& other : quick_extreme_suite()) {
    if (other.name == extreme.promise.like) before.push_back(try_case(other, {}));
  }
  const Outcome outcome = try_case(extreme, before);
  for (const std::string& sentence : outcome.broken) ADD_FAILURE() << sentence;
  EXPECT_TRUE(outcome.finite);
  EXPECT_NE(outcome.ran, !outcome.refusal.empty() && !extreme.unchecked);
}

INSTANTIATE_TEST_SUITE_P(, QuickSuite, testing::ValuesIn(quick_extreme_suite()),
                         [](const auto& about) { return as_test_name(about.param.name); });

TEST(ExtremeSuite, NamesAreUniqueAndComparisonsComeLater) {
  std::vector<std::string> names;
  for (const ExtremeCase& c : extreme_suite()) {
    EXPECT_EQ(std::ranges::count(names, c.name), 0) << c.name;
    if (!c.promise.like.empty()) {
      EXPECT_EQ(std::ranges::count(names, c.promise.like), 1) << c.name;
    }
    names.push_back(c.name);
  }
  EXPECT_GE(names.size(), 25U);
}

}  // namespace
}  // namespace leda::solver::test
