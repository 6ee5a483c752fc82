#include "solver/screening/empirical_retrogression.hpp"

#include <gtest/gtest.h>

#include <map>

#include "solver/screening/remolding_energy.hpp"
#include "solver/screening/slide_energy.hpp"
#include "solver/screening/strength_ratios.hpp"
#include "tests/screening/banks.hpp"

namespace leda::solver {
namespace {

using test::table;

struct SiteRow {
  std::string name;
  Site site;
  double potential = 0, thesis_energy = 0, right_energy = 0, stability = 0;
};

SiteRow site_row(const test::Row& row) {
  SiteRow s{row.text("site"), test::site_of_row(row)};
  const PostPeakCurve curve = *post_peak_curve(s.site);
  s.potential = potential_energy(s.site.unit_weight, s.site.height_m);
  s.thesis_energy = remolding_energy_thesis_reading(curve);
  s.right_energy = remolding_energy(curve);
  s.stability = stability_number(s.site.unit_weight, s.site.height_m, s.site.peak_strength_Pa);
  return s;
}

std::vector<SiteRow> seven_sites() {
  std::vector<SiteRow> sites;
  for (const auto& row : table("thesis_tables_3_3_3_4.csv")) sites.push_back(site_row(row));
  return sites;
}

Estimate thesis_mode(const SiteRow& s) {
  return urmi_2023(s.potential, s.thesis_energy, *s.site.liquidity_index, s.site.unit_weight,
                   omega_thesis());
}

Estimate corrected_mode(const SiteRow& s) {
  return urmi_2023(s.potential, s.right_energy, *s.site.liquidity_index, s.site.unit_weight,
                   omega_corrected());
}

TEST(Urmi2023Thesis, ReproducesTable37WhereItCanBe) {
  const auto printed = table("thesis_table_3_7.csv");
  const auto sites = seven_sites();
  for (std::size_t i = 0; i < sites.size(); ++i) {
    if (sites[i].name == "Casselman" || sites[i].name == "Bekkelaget") continue;
    ASSERT_TRUE(thesis_mode(sites[i]).metres) << sites[i].name;
    // Sainte-Monique is 150.76, printed 150: cut off, not rounded.
    EXPECT_NEAR(*thesis_mode(sites[i]).metres, printed[i]["eq_3_22"], 0.8) << sites[i].name;
  }
}

// Tables 3-6 and 3-7 use 19 kN/m3 at Casselman where Table 3-3 has 17.
TEST(Urmi2023Thesis, CasselmanOfTable37HoldsOnlyWithAnotherUnitWeight) {
  SiteRow casselman = seven_sites().front();
  EXPECT_NEAR(*thesis_mode(casselman).metres, 154.8, 0.2);
  casselman.site.unit_weight = 19e3;
  casselman.potential = potential_energy(19e3, 44);
  EXPECT_NEAR(*thesis_mode(casselman).metres, 456, 1);
  EXPECT_NEAR((casselman.potential - casselman.thesis_energy) / 1000, 182.53, 0.1);
  EXPECT_NEAR(*mitchell_markell_1974(stability_number(19e3, 44, 87e3)).metres, 560.9, 0.1);
  EXPECT_NEAR(*mitchell_markell_1974(stability_number(17e3, 44, 87e3)).metres, 459.8, 0.1);
}

TEST(Urmi2023Thesis, EnergyLeftAndOmegaReproduceTable36) {
  const auto printed = table("thesis_table_3_6.csv");
  const auto sites = seven_sites();
  for (std::size_t i = 1; i < sites.size(); ++i) {  // Casselman: see above
    const double left = (sites[i].potential - sites[i].thesis_energy) / 1000;
    EXPECT_NEAR(left, printed[i]["energy_left"], 0.06) << sites[i].name;
    EXPECT_NEAR(left / printed[i]["retrogression_m"], printed[i]["omega"], 0.006) << sites[i].name;
  }
}

TEST(Urmi2023, IsRefusedWhereOmegaIsNotPositive) {
  const SiteRow bekkelaget = seven_sites().back();
  EXPECT_NEAR(omega_thesis().at(2.4, 18.9e3), -0.336, 1e-12);
  EXPECT_FALSE(thesis_mode(bekkelaget).metres);
  EXPECT_NE(thesis_mode(bekkelaget).why_not.find("omega"), std::string::npos);
  EXPECT_FALSE(corrected_mode(bekkelaget).metres);
  EXPECT_FALSE(urmi_2023(500e3, 100e3, 2.1, 20e3, omega_thesis()).metres);  // I_L m = 42: omega 0
}

TEST(Urmi2023, IsRefusedWhereNoEnergyIsLeft) {
  const Estimate estimate = urmi_2023(100e3, 150e3, 1, 16e3, omega_corrected());
  EXPECT_FALSE(estimate.metres);
  EXPECT_NE(estimate.why_not.find("remolding energy"), std::string::npos);
}

TEST(Urmi2023Corrected, IsRefittedToTheRightEnergies) {
  const OmegaLine line = omega_corrected();
  EXPECT_NEAR(line.intercept, 5.8493, 5e-4);
  EXPECT_NEAR(line.slope, -0.1444, 5e-5);
  EXPECT_GT(line.spread, 0);
  // A least-squares line never fits worse than another line does to the same points.
  EXPECT_GT(line.r_squared, 0.8);
}

TEST(Urmi2023Corrected, SpreadIsThatOfTheFiveSites) {
  const OmegaLine line = omega_corrected();
  const auto printed = table("thesis_table_3_6.csv");
  const auto sites = seven_sites();
  double squares = 0;
  for (std::size_t i = 0; i < 5; ++i) {
    const double omega =
        (sites[i].potential - sites[i].right_energy) / 1000 / printed[i]["retrogression_m"];
    squares +=
        std::pow(omega - line.at(*sites[i].site.liquidity_index, sites[i].site.unit_weight), 2);
  }
  EXPECT_NEAR(line.spread, std::sqrt(squares / 3), 1e-9);
}

TEST(Urmi2023Corrected, RangeHoldsTheEstimate) {
  for (const SiteRow& s : seven_sites()) {
    const Estimate e = corrected_mode(s);
    if (!e.range) continue;
    EXPECT_LT(e.range->at(0), *e.metres) << s.name;
    EXPECT_GT(e.range->at(1), *e.metres) << s.name;
  }
}

// The coefficients of eq. 3-21 with the right energies overshoot: the two may not be mixed.
TEST(Urmi2023, MixingModesIsWrong) {
  const SiteRow jude = seven_sites().at(2);
  const Estimate mixed = urmi_2023(jude.potential, jude.right_energy, 1.2, 16.5e3, omega_thesis());
  EXPECT_NEAR(*mixed.metres, 113.78, 0.05);
  EXPECT_NEAR(*thesis_mode(jude).metres, 64.86, 0.05);  // observed: 80
}

// With Casselman at 19 kN/m3 the five printed omegas give eq. 3-21; with 17 they do not.
TEST(Urmi2023Thesis, CoefficientsNeedCasselmanAtNineteen) {
  const auto fit = [](double casselman_unit_weight) {
    const auto printed = table("thesis_table_3_6.csv");
    const auto sites = seven_sites();
    double x = 0, y = 0, xx = 0, xy = 0;
    for (std::size_t i = 0; i < 5; ++i) {
      const double m = i == 0 ? casselman_unit_weight : sites[i].site.unit_weight / 1000;
      const double at = m * *sites[i].site.liquidity_index;
      const double omega = printed[i]["energy_left"] / printed[i]["retrogression_m"];
      x += at, y += omega, xx += at * at, xy += at * omega;
    }
    const double slope = (5 * xy - x * y) / (5 * xx - x * x);
    return std::pair{(y - slope * x) / 5, slope};
  };
  EXPECT_NEAR(fit(19).first, 4.1957, 5e-4);
  EXPECT_NEAR(fit(19).second, -0.0990, 5e-5);
  EXPECT_NEAR(fit(17).first, 4.6022, 5e-4);
  EXPECT_NEAR(fit(17).second, -0.1208, 5e-5);
}

TEST(Quinn2011, ReproducesTable37ButForBekkelaget) {
  const auto sites = seven_sites();
  const auto printed = table("thesis_table_3_7.csv");
  for (std::size_t i = 0; i < sites.size(); ++i) {
    const double metres = quinn_2011(sites[i].site.height_m, printed[i]["slope_angle_deg"]);
    if (sites[i].name == "Bekkelaget") {
      EXPECT_NEAR(metres, 50.95, 0.005);  // printed 49
      continue;
    }
    EXPECT_NEAR(metres, printed[i]["quinn"], 0.5) << sites[i].name;
  }
}

// The lower bounds printed for four sites are 2 H, not 4 H.
TEST(CarsonLajoie1981, LowerBoundOfFourSitesIsPrintedAsTwoHeights) {
  const std::map<std::string, double> printed_heights{{"Saint-Barnabe-Nord", 2},
                                                      {"Saint-Jude", 2},
                                                      {"Saint-Luc-de-Vincennes", 2},
                                                      {"Sainte-Monique", 2}};
  const auto sites = seven_sites();
  const auto printed = table("thesis_table_3_7.csv");
  for (std::size_t i = 0; i < sites.size(); ++i) {
    const auto range = carson_lajoie_1981(sites[i].site.height_m);
    EXPECT_NEAR(range[1], printed[i]["carson_lajoie_high"], 0.5) << sites[i].name;
    const auto wrong = printed_heights.find(sites[i].name);
    const double heights = wrong == printed_heights.end() ? 4 : wrong->second;
    EXPECT_NEAR(heights * sites[i].site.height_m, printed[i]["carson_lajoie_low"], 0.05);
    EXPECT_DOUBLE_EQ(range[0], 4 * sites[i].site.height_m);
  }
}

TEST(MitchellMarkell1974, ReproducesTable37ButForCasselmanAndBekkelaget) {
  const auto sites = seven_sites();
  const auto printed = table("thesis_table_3_7.csv");
  for (std::size_t i = 0; i < sites.size(); ++i) {
    const Estimate e = mitchell_markell_1974(sites[i].stability);
    if (sites[i].name == "Rockcliffe") {
      EXPECT_FALSE(e.metres);  // N_s = 3.8 < 6, printed N/A
    } else if (sites[i].name == "Bekkelaget") {
      EXPECT_NEAR(*e.metres, 1466.7, 0.05);  // printed 1566 = 100 (N_s - 3)
      EXPECT_NEAR(100 * (sites[i].stability - 3), printed[i]["mitchell_markell"], 0.7);
    } else if (sites[i].name != "Casselman") {
      EXPECT_NEAR(*e.metres, printed[i]["mitchell_markell"], 0.9) << sites[i].name;
    }
  }
}

TEST(Nve, ReproducesTable37) {
  const auto sites = seven_sites();
  const auto printed = table("thesis_table_3_7.csv");
  for (std::size_t i = 0; i < sites.size(); ++i) {
    EXPECT_NEAR(nve_1_15(sites[i].site.height_m), printed[i]["nve"], 1e-9) << sites[i].name;
  }
}

TEST(StrengthRatios, SensitivityReproducesTable33) {
  for (const auto& row : table("thesis_tables_3_3_3_4.csv")) {
    // Bekkelaget is 81, printed 80.
    const double tolerance = row.text("site") == "Bekkelaget" ? 1.01 : 0.5;
    EXPECT_NEAR(sensitivity(row["peak_kPa"], row["remolded_kPa"]), row["sensitivity"], tolerance);
  }
}

TEST(StrengthRatios, BrittlenessIsTheShareLost) {
  EXPECT_DOUBLE_EQ(brittleness_index(40, 1), 0.975);
  EXPECT_DOUBLE_EQ(brittleness_index(40, 40), 0);
}

}  // namespace
}  // namespace leda::solver
