#include "solver/screening/analytics.hpp"

#include <gtest/gtest.h>

#include "tests/screening/banks.hpp"

namespace leda::solver {
namespace {

Site sainte_monique() {
  for (const auto& row : test::table("thesis_tables_3_3_3_4.csv")) {
    if (row.text("site") == "Sainte-Monique") return test::site_of_row(row);
  }
  throw std::runtime_error("no Sainte-Monique in the table");
}

Criterion named(const Analytics& a, const std::string& name) {
  for (const Criterion& c : a.criteria) {
    if (c.name == name) return c;
  }
  throw std::runtime_error("no criterion " + name);
}

TEST(Analytics, OfACompleteSiteLackOnlyWhatNeedsThePreconsolidation) {
  Site site = sainte_monique();
  site.slope_angle_deg = 24;
  const Analytics a = analyse(site);
  EXPECT_EQ(a.missing.size(), 1U);
  EXPECT_TRUE(a.missing.contains("limit_state_energy"));
  EXPECT_NEAR(*a.stability_number, 17.7778, 1e-4);
  EXPECT_NEAR(*a.remolding.complete_curve, 36014, 5);
  EXPECT_NEAR(*a.retrogression.urmi_2023_thesis, 150.76, 0.05);
  EXPECT_NEAR(*a.retrogression.quinn_2011, 18.44, 0.005);
}

TEST(Analytics, OfABareSiteSayWhatIsMissing) {
  Site site;
  site.height_m = 20;
  site.unit_weight = 17e3;
  site.peak_strength_Pa = 40e3;
  const Analytics a = analyse(site);
  EXPECT_NEAR(*a.stability_number, 8.5, 1e-12);
  EXPECT_NEAR(*a.retrogression.mitchell_markell_1974, 450, 1e-9);
  EXPECT_FALSE(a.sensitivity);
  EXPECT_FALSE(a.remolding.complete_curve);
  EXPECT_FALSE(a.retrogression.urmi_2023_thesis);
  EXPECT_NE(a.missing.at("sensitivity").find("remolded strength"), std::string::npos);
  EXPECT_NE(a.missing.at("remolding_energy").find("softening"), std::string::npos);
  EXPECT_NE(a.missing.at("urmi_2023_corrected").find("liquidity index"), std::string::npos);
  EXPECT_NE(a.missing.at("quinn_2011").find("slope angle"), std::string::npos);
}

TEST(Analytics, PeakStrainComesFromThePreconsolidationWhereNotGiven) {
  Site site = sainte_monique();
  site.peak_strain.reset();
  EXPECT_FALSE(analyse(site).peak_strain);
  site.preconsolidation_Pa = 150e3;
  const Analytics a = analyse(site);
  EXPECT_NEAR(*a.limit_state_energy, 1950, 1e-9);
  EXPECT_NEAR(*a.peak_strain, 2 * 1950 / 40.5e3, 1e-12);
  EXPECT_TRUE(a.remolding.complete_curve);
}

TEST(Criteria, VerdictsAtSainteMonique) {
  const Analytics a = analyse(sainte_monique());  // N_s 17.8, I_L 1.0, s_ur 0.74 kPa, S_t 54.7
  EXPECT_TRUE(*named(a, "Mitchell and Markell").met);
  EXPECT_TRUE(*named(a, "Lebuis and Rissmann").met);
  EXPECT_TRUE(*named(a, "Lebuis et al., retrogression of 100 m").met);
  EXPECT_TRUE(*named(a, "Tavenas et al.").met);
  EXPECT_TRUE(*named(a, "Tavenas et al., energy").met);
  EXPECT_TRUE(*named(a, "Lefebvre").met);
  EXPECT_TRUE(*named(a, "Thakur and Degago").met);
  EXPECT_FALSE(*named(a, "Demers et al.").met);  // I_L 1.0 < 1.5
}

TEST(Criteria, AreUnknownOnlyWhereAMissingInputDecides) {
  Site site = sainte_monique();
  site.liquidity_index.reset();
  Analytics a = analyse(site);
  EXPECT_TRUE(*named(a, "Lebuis and Rissmann").met);  // s_ur alone is enough
  EXPECT_FALSE(named(a, "Demers et al.").met.has_value());
  site.remolded_strength_Pa = 3e3;
  a = analyse(site);
  EXPECT_FALSE(named(a, "Lebuis and Rissmann").met.has_value());
  EXPECT_FALSE(*named(a, "Demers et al.").met);  // s_ur alone refuses
  EXPECT_FALSE(*named(a, "Thakur and Degago").met);
}

TEST(Criteria, ThresholdsAreThoseOfChapter2) {
  Site site = sainte_monique();
  const auto met = [&](const char* name) { return *named(analyse(site), name).met; };
  site.remolded_strength_Pa = 1.4e3;
  EXPECT_TRUE(met("Lefebvre"));
  site.remolded_strength_Pa = 1.6e3;
  EXPECT_FALSE(met("Lefebvre"));
  site.liquidity_index = 1.21;
  EXPECT_TRUE(met("Lebuis and Rissmann"));
  site.liquidity_index = 1.19;
  EXPECT_FALSE(met("Lebuis and Rissmann"));
  EXPECT_FALSE(met("Tavenas et al."));
  site.liquidity_index = 2.1;
  EXPECT_TRUE(met("Tavenas et al."));
  site.height_m = 4.1 * site.peak_strength_Pa / site.unit_weight;  // N_s 4.1
  EXPECT_FALSE(met("Lefebvre"));
  EXPECT_FALSE(met("Mitchell and Markell"));
  EXPECT_TRUE(met("Tavenas et al."));
  site.height_m = 3.9 * site.peak_strength_Pa / site.unit_weight;
  EXPECT_FALSE(met("Tavenas et al."));
}

TEST(Criteria, SayTheirThresholdAndTheNumber) {
  const Analytics a = analyse(sainte_monique());
  EXPECT_EQ(named(a, "Mitchell and Markell").why, "N_s = 17.78 > 6");
  EXPECT_EQ(named(a, "Thakur and Degago").why, "s_ur = 0.74 < 1 kPa");
}

}  // namespace
}  // namespace leda::solver
