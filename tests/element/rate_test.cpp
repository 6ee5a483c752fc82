// Rate and flow laws against hand values and their limits.

#include "solver/materials/rate.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace leda::solver {
namespace {

TEST(SemiLogarithmic, GainsItsShareWithEveryDecade) {
  const RateLaw law = SemiLogarithmicRate{0.1, 1e-3};
  EXPECT_DOUBLE_EQ(strength_factor(law, 1e-3), 1);
  EXPECT_NEAR(strength_factor(law, 1e-2), 1.1, 1e-12);
  EXPECT_NEAR(strength_factor(law, 1.0), 1.3, 1e-12);
}

TEST(SemiLogarithmic, HoldsTheReferenceStrengthAtRest) {
  const RateLaw law = SemiLogarithmicRate{0.2, 1e-3};
  EXPECT_DOUBLE_EQ(strength_factor(law, 0), 1);  // the bare formula is -infinity here
  EXPECT_DOUBLE_EQ(strength_factor(law, 1e-9), 1);
}

TEST(Power, IsTheTenthRootOfTheRate) {
  const RateLaw law = PowerRate{0.1, 0.01};
  EXPECT_NEAR(strength_factor(law, 0.1), std::pow(10.0, 0.1), 1e-12);  // 1.2589
  EXPECT_NEAR(strength_factor(law, 10.24), 2, 1e-12);                  // 2^10 times the reference
  EXPECT_DOUBLE_EQ(strength_factor(law, 0), 1);
}

TEST(AdditivePower, IsOneAtRestAndOnePlusEtaAtTheReference) {
  const RateLaw law = AdditivePowerRate{0.5, 0.5, 0.04};
  EXPECT_DOUBLE_EQ(strength_factor(law, 0), 1);
  EXPECT_DOUBLE_EQ(strength_factor(law, 0.04), 1.5);
  EXPECT_DOUBLE_EQ(strength_factor(law, 0.16), 2);
}

TEST(AdditivePower, IsHerschelBulkleyWithTheYieldStressTakenOut) {
  // eq. 2-8 times s_u,ref is eq. 2-7 with eta' = eta s_u,ref / rate_ref^n.
  const AdditivePowerRate law{0.3, 0.4, 0.02};
  const double yield = 900;
  const HerschelBulkleyFlow flow{0.3 * yield / std::pow(0.02, 0.4), 0.4};
  for (const double rate : {0.001, 0.1, 3.0}) {
    EXPECT_NEAR(yield * strength_factor(law, rate), flow_stress(flow, yield, rate), 1e-9);
  }
}

TEST(Bingham, FlowsByTheOverstressAlone) {
  const FlowLaw law = BinghamFlow{120};
  EXPECT_DOUBLE_EQ(flow_stress(law, 1000, 2.5), 1300);
  EXPECT_DOUBLE_EQ(flow_rate(law, 1000, 1300), 2.5);
  EXPECT_DOUBLE_EQ(flow_rate(law, 1000, 1000), 0);
  EXPECT_DOUBLE_EQ(flow_rate(law, 1000, 200), 0);
}

TEST(HerschelBulkley, IsBinghamForAnExponentOfOne) {
  const FlowLaw law = HerschelBulkleyFlow{120, 1};
  EXPECT_DOUBLE_EQ(flow_stress(law, 1000, 2.5), 1300);
  EXPECT_DOUBLE_EQ(flow_rate(law, 1000, -1300), 2.5);
}

TEST(HerschelBulkley, ThinsUnderShear) {
  const HerschelBulkleyFlow law{200, 0.5};
  EXPECT_DOUBLE_EQ(flow_stress(law, 500, 4), 900);
  const auto viscosity = [&](double rate) { return (flow_stress(law, 500, rate) - 500) / rate; };
  EXPECT_LT(viscosity(10), viscosity(1));
}

TEST(EveryRateLaw, RateOfAStressGivesTheStressBackAndNeverWeakens) {
  for (const FlowLaw& law : {FlowLaw{BinghamFlow{50}}, FlowLaw{HerschelBulkleyFlow{80, 0.35}}}) {
    for (const double stress : {1001.0, 1500.0, 9000.0}) {
      EXPECT_NEAR(flow_stress(law, 1000, flow_rate(law, 1000, stress)), stress, 1e-9 * stress);
    }
  }
  for (const RateLaw& law :
       {RateLaw{SemiLogarithmicRate{0.1, 0.01}}, RateLaw{PowerRate{0.05, 0.01}},
        RateLaw{AdditivePowerRate{0.2, 0.6, 0.01}}}) {
    double before = 1;
    for (int i = 0; i < 34; ++i) {  // to 8590 per second
      const double rate = 1e-6 * (std::pow(2, i) - 1);
      EXPECT_GE(strength_factor(law, rate), before);
      EXPECT_DOUBLE_EQ(strength_factor(law, -rate), strength_factor(law, rate));
      before = strength_factor(law, rate);
    }
  }
}

}  // namespace
}  // namespace leda::solver
