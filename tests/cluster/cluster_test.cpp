// All of it is one test of ctest, so that Slurm comes up once: where a case of it was skipped, so
// was the test, which its exit code says. A regular expression over the output would call it
// skipped where another case failed, too.

#include <gtest/gtest.h>

namespace {
constexpr int skipped = 77;
}

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (const int failed = RUN_ALL_TESTS(); failed != 0) return failed;
  return testing::UnitTest::GetInstance()->skipped_test_count() > 0 ? skipped : 0;
}
