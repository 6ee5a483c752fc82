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

TEST(Bound, HasOneNameEachBothWays) {
  for (const Bound bound : {Bound::measured, Bound::lower_bound}) {
    EXPECT_EQ(bound_from(to_string(bound)), bound);
  }
  EXPECT_STREQ(to_string(Bound::lower_bound), "lower-bound");
  EXPECT_FALSE(bound_from("lower_bound"));
}

TEST(Bound, EndsAndEdgesTellWhatADistanceIs) {
  const auto marked = [](RunStatus status, std::vector<std::string> warnings) {
    SectionResult r;
    r.status = status;
    r.warnings = std::move(warnings);
    mark_lower_bounds(r);
    return std::pair{r.retrogression_is, r.runout_is};
  };
  const auto low = Bound::lower_bound, measured = Bound::measured;
  EXPECT_EQ(marked(RunStatus::at_rest, {"anything"}), std::pair(measured, measured));
  EXPECT_EQ(marked(RunStatus::stable, {}), std::pair(measured, measured));
  EXPECT_EQ(marked(RunStatus::time_limit, {}), std::pair(low, low));
  EXPECT_EQ(marked(RunStatus::left_domain, {}), std::pair(low, low));
  EXPECT_EQ(marked(RunStatus::unstable, {}), std::pair(low, low));
  EXPECT_EQ(marked(RunStatus::at_rest,
                   {"the backscarp reached the model's edge: retrogression is a lower bound"}),
            std::pair(low, measured));
  EXPECT_EQ(
      marked(RunStatus::at_rest, {"the front reached the model's edge: runout is a lower bound"}),
      std::pair(measured, low));
}

}  // namespace
}  // namespace leda
