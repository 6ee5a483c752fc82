#include "server/documents/screening_document.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "solver/screening/site_material.hpp"
#include "tests/screening/banks.hpp"

namespace leda::server {
namespace {

using nlohmann::json;

/// Sainte-Monique, Tables 3-3, 3-4 and 3-7.
const char* const sainte_monique = R"({
  "name": "Sainte-Monique", "height_m": 45, "slope_angle_deg": 24, "unit_weight_kN_m3": 16,
  "peak_strength_kPa": 40.5, "remolded_strength_kPa": 0.74, "peak_strain": 0.024,
  "softening": {"alpha": 0.952, "beta": 2.8, "residual_strain": 1.8},
  "plasticity_index_percent": 28, "liquidity_index": 1, "preconsolidation_kPa": 150})";

json screened(const json& site) {
  const auto parsed = parse_site_file(site.dump());
  if (!parsed)
    throw std::runtime_error(parsed.faults.front().pointer + parsed.faults.front().message);
  return to_document(solver::screen_site(*parsed.value));
}

bool has_reason(const json& document, const std::string& part) {
  return std::ranges::any_of(document.at("reasons"), [&](const json& reason) {
    return reason.get<std::string>().find(part) != std::string::npos;
  });
}

TEST(ScreeningDocument, OfASiteHasEveryKeyOfTheFormat) {
  const json d = screened(json::parse(sainte_monique));
  for (const char* key : {"stability_number", "sensitivity", "potential_energy_kJ_m3",
                          "remolding_energy_kJ_m3", "remolding_energy_by", "criteria",
                          "empirical_retrogression_m", "factor_of_safety", "decision", "reasons"}) {
    EXPECT_TRUE(d.contains(key)) << key;
  }
  for (const char* key : {"urmi_2023_thesis", "urmi_2023_corrected", "quinn_2011",
                          "carson_lajoie_1981", "mitchell_markell_1974", "nve_1_15"}) {
    EXPECT_TRUE(d.at("empirical_retrogression_m").contains(key)) << key;
  }
  for (const char* drainage : {"drained", "undrained"}) {
    for (const char* method : {"bishop", "spencer", "morgenstern_price"}) {
      EXPECT_TRUE(d.at("factor_of_safety").at(drainage).contains(method)) << method;
    }
  }
  for (const json& c : d.at("criteria")) {
    EXPECT_TRUE(c.contains("name") && c.contains("met") && c.contains("why"));
  }
}

TEST(ScreeningDocument, OfASiteHasTheRightNumbers) {
  const json d = screened(json::parse(sainte_monique));
  EXPECT_NEAR(d["stability_number"], 17.7778, 1e-3);
  EXPECT_NEAR(d["sensitivity"], 54.73, 0.01);
  EXPECT_NEAR(d["potential_energy_kJ_m3"], 480, 1e-9);
  EXPECT_NEAR(d["remolding_energy_kJ_m3"], 36.01, 0.01);
  EXPECT_NEAR(d["remolding_energy_by"]["leroueil"], 181.44, 1e-9);
  EXPECT_NEAR(d["remolding_energy_by"]["thesis_reading"], 88.02, 0.01);
  EXPECT_NEAR(d["limit_state_energy_kJ_m3"], 1.95, 1e-9);
  EXPECT_NEAR(d["empirical_retrogression_m"]["urmi_2023_thesis"], 150.76, 0.05);
  EXPECT_EQ(d["empirical_retrogression_m"]["carson_lajoie_1981"], json({180.0, 1215.0}));
  EXPECT_EQ(d["decision"], "simulate");
  EXPECT_TRUE(d["factor_of_safety"]["drained"]["bishop"].is_null());
  EXPECT_TRUE(d["factor_of_safety"]["undrained"]["bishop"].is_number());
}

TEST(ScreeningDocument, WhatIsMissingIsNullAndSaysWhy) {
  const json d = screened({{"height_m", 10}, {"unit_weight_kN_m3", 17}, {"peak_strength_kPa", 40}});
  EXPECT_TRUE(d["sensitivity"].is_null());
  EXPECT_TRUE(d["remolding_energy_kJ_m3"].is_null());
  EXPECT_TRUE(d["empirical_retrogression_m"]["quinn_2011"].is_null());
  EXPECT_TRUE(d["empirical_retrogression_m"]["mitchell_markell_1974"].is_null());
  EXPECT_TRUE(has_reason(d, "sensitivity is null: not given: remolded strength"));
  EXPECT_TRUE(has_reason(d, "quinn_2011 is null: not given: slope angle"));
  EXPECT_TRUE(has_reason(d, "mitchell_markell_1974 is null: N_s"));
  EXPECT_TRUE(has_reason(d, "factor_of_safety.undrained is null"));
}

TEST(SiteFile, EveryFaultAtOnceWithItsPointer) {
  json site = json::parse(sainte_monique);
  site["height_m"] = -3;
  site["slope_angle_deg"] = 95;
  site["peak_strain"] = 1.5;
  site["remolded_strength_kPa"] = 50;
  site["softening"].erase("beta");
  site["softening"]["betta"] = 2.8;
  site["colour"] = "blue";
  const auto parsed = parse_site_file(site.dump());
  ASSERT_FALSE(parsed);
  std::vector<std::string> pointers;
  for (const Fault& fault : parsed.faults) pointers.push_back(fault.pointer);
  for (const char* wanted : {"/height_m", "/slope_angle_deg", "/peak_strain", "/softening/beta",
                             "/softening/betta", "/colour", "/remolded_strength_kPa"}) {
    EXPECT_TRUE(std::ranges::count(pointers, wanted) == 1) << wanted;
  }
  EXPECT_EQ(pointers.size(), 7U);
}

TEST(SiteFile, HostileTextIsRefused) {
  for (const char* text :
       {"", "{", "[]", "null", "{\"height_m\": \"ten\"}", "{\"height_m\": 1e999}",
        "{\"height_m\": null}", "{\"height_m\": 1, \"height_m\": 2}"}) {
    const auto parsed = parse_site_file(text);
    EXPECT_FALSE(parsed) << text;
    EXPECT_FALSE(parsed.faults.empty()) << text;
  }
}

TEST(SiteFile, WhatNoCaseMayHaveNoSiteMay) {
  const auto parsed = parse_site_file(R"({"height_m": 15, "unit_weight_kN_m3": 1.7,
      "peak_strength_kPa": 40000, "remolded_strength_kPa": 0.0005,
      "softening": {"alpha": 0.95, "beta": 2.8, "residual_strain": 180}})");
  std::set<std::string> pointers;
  for (const Fault& fault : parsed.faults) pointers.insert(fault.pointer);
  EXPECT_EQ(pointers,
            (std::set<std::string>{"/unit_weight_kN_m3", "/peak_strength_kPa",
                                   "/remolded_strength_kPa", "/softening/residual_strain"}));
}

TEST(SiteFile, WhatIsOddIsTold) {
  json site = json::parse(sainte_monique);
  const auto told = [&] { return solver::warnings_of(*parse_site_file(site.dump()).value); };
  EXPECT_TRUE(told().empty()) << told().front();
  site["softening"]["beta"] = 0.028;
  site["plasticity_index_percent"] = 0.28;
  site["preconsolidation_kPa"] = 150'000;
  site["height_m"] = 4500;
  const auto warnings = told();
  ASSERT_EQ(warnings.size(), 4U);
  EXPECT_NE(warnings[0].find("not per percent"), std::string::npos);
  EXPECT_NE(warnings[1].find("height_m is 4500"), std::string::npos);
}

TEST(SiteFile, UnitsAreThoseOfTheirNames) {
  const auto parsed = parse_site_file(sainte_monique);
  ASSERT_TRUE(parsed);
  EXPECT_DOUBLE_EQ(parsed.value->unit_weight, 16e3);
  EXPECT_DOUBLE_EQ(parsed.value->peak_strength_Pa, 40.5e3);
  EXPECT_DOUBLE_EQ(*parsed.value->remolded_strength_Pa, 740);
  EXPECT_DOUBLE_EQ(*parsed.value->plasticity_index, 0.28);
  EXPECT_DOUBLE_EQ(*parsed.value->preconsolidation_Pa, 150e3);
}

}  // namespace
}  // namespace leda::server
