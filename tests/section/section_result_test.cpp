#include "solver/section/section_result.hpp"

#include <gtest/gtest.h>

namespace leda {
namespace {

TEST(RunStatus, HasOneNameEachBothWays) {
  for (const RunStatus status :
       {RunStatus::stable, RunStatus::at_rest, RunStatus::time_limit, RunStatus::left_domain,
        RunStatus::unstable, RunStatus::interrupted}) {
    EXPECT_EQ(run_status_from(to_string(status)), status);
  }
  EXPECT_STREQ(to_string(RunStatus::at_rest), "at-rest");
  EXPECT_FALSE(run_status_from("at_rest"));
  EXPECT_FALSE(run_status_from(""));
}

}  // namespace
}  // namespace leda
