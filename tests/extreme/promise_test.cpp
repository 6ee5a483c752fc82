// A promise that is broken must be seen to be broken.

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "solver/extremes/banks.hpp"
#include "solver/extremes/finite.hpp"
#include "solver/extremes/try_case.hpp"
#include "solver/run/simulate.hpp"

namespace leda::solver::test {
namespace {

ExtremeCase slump() {
  ExtremeCase c;
  c.name = "slump";
  c.section = bank_of_clay({.height_m = 6}, plain_clay(12e3));
  c.settings = settings_of(1, 15);
  return c;
}

bool says(const Outcome& o, const std::string& part) {
  return std::ranges::any_of(
      o.broken, [&](const std::string& s) { return s.find(part) != std::string::npos; });
}

TEST(Promise, IsKeptBySoundGround) {
  const Outcome o = try_case(slump(), {});
  EXPECT_TRUE(o.kept()) << o.broken.front();
  EXPECT_TRUE(o.ran);
  EXPECT_GT(o.result.crest_to_crest_retrogression_m, 2);
}

TEST(Promise, AnotherEndBreaksIt) {
  ExtremeCase c = slump();
  c.promise.statuses = {RunStatus::stable};
  EXPECT_TRUE(says(try_case(c, {}), "ended at-rest"));
}

TEST(Promise, AnEnergyErrorAboveTheLimitBreaksIt) {
  ExtremeCase c = slump();
  c.promise.most_energy_error = 1e-9;
  EXPECT_TRUE(says(try_case(c, {}), "energy"));
}

TEST(Promise, ABandThatIsMissedBreaksIt) {
  ExtremeCase c = slump();
  c.promise.retrogression_m = Band{100, 200};
  EXPECT_TRUE(says(try_case(c, {}), "retrogression"));
}

TEST(Promise, ADifferenceToItsLikeBreaksIt) {
  ExtremeCase c = slump();
  Outcome other;
  other.name = "other";
  other.result.crest_to_crest_retrogression_m = 50;
  c.promise.like = "other";
  EXPECT_TRUE(says(try_case(c, {other}), "they must agree"));
  EXPECT_TRUE(says(try_case(c, {}), "nothing to be compared with"));
}

TEST(Promise, ARefusalIsPartOfIt) {
  ExtremeCase c = slump();
  c.refused_at = "/time_step_factor";
  EXPECT_TRUE(says(try_case(c, {}), "not refused at /time_step_factor"));
  c.settings.time_step_factor = 1.1;
  EXPECT_TRUE(try_case(c, {}).kept());
  c.refused_at.clear();
  EXPECT_TRUE(says(try_case(c, {}), "is refused"));
}

TEST(Promise, AnInterruptionBreaksIt) {
  EXPECT_TRUE(says(try_case(slump(), {}, [] { return true; }), "interrupted"));
}

TEST(Promise, TheCriticalNumberPartsStandingFromFailing) {
  const auto status_at = [](double number) {
    const ExtremeCase c = slump();
    const double strength = 17e3 * 6 / number;
    return simulate(bank_of_clay({.height_m = 6}, plain_clay(strength)), c.settings).status;
  };
  ExtremeCase c = slump();
  c.critical = CriticalNumber{{4.5, 9}, 0.3};
  const Outcome o = try_case(c, {});
  ASSERT_TRUE(o.critical_number);
  EXPECT_EQ(status_at(*o.critical_number - 0.3), RunStatus::stable);
  EXPECT_NE(status_at(*o.critical_number + 0.3), RunStatus::stable);
}

TEST(Finite, EveryFieldOfAResultCounts) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(is_finite(SectionResult{}));
  for (double SectionResult::*field :
       {&SectionResult::crest_to_crest_retrogression_m, &SectionResult::runout_m,
        &SectionResult::runout_from_crest_m, &SectionResult::simulated_s,
        &SectionResult::numerical_dissipation, &SectionResult::ns_per_particle_step}) {
    SectionResult r;
    r.*field = nan;
    EXPECT_FALSE(is_finite(r));
  }
  SectionResult r;
  r.profile_after = {{0, 1}, {1, nan}};
  EXPECT_FALSE(is_finite(r));
}

TEST(Finite, EveryFieldOfAFrameCounts) {
  EXPECT_TRUE(is_finite(Frame{}));
  for (std::vector<float> Frame::*field :
       {&Frame::x, &Frame::z, &Frame::velocity_x, &Frame::velocity_z, &Frame::stress_xx,
        &Frame::stress_zz, &Frame::stress_xz, &Frame::stress_yy, &Frame::plastic_strain,
        &Frame::strength, &Frame::volume}) {
    Frame f;
    f.*field = {0, std::numeric_limits<float>::infinity()};
    EXPECT_FALSE(is_finite(f));
  }
}

}  // namespace
}  // namespace leda::solver::test
