#include <gtest/gtest.h>

#include <functional>

#include "solver/section/validate.hpp"
#include "solver/section/warnings.hpp"
#include "tests/section/bank.hpp"

namespace leda {
namespace {

using Change = std::function<void(Material&)>;

UrmiSoftening& urmi(Material& m) { return std::get<UrmiSoftening>(m.softening->law); }

// A mistake of units, and what is said of it: a fault at a pointer, or a warning.
struct Mistake {
  const char* name;
  Change change;
  const char* fault;    // its pointer; empty: none
  const char* warning;  // a part of it; empty: none
};

void PrintTo(const Mistake& one, std::ostream* out) { *out << one.name; }

class OddMaterial : public testing::TestWithParam<Mistake> {};

TEST_P(OddMaterial, IsRefusedOrTold) {
  Material m = test::softening_clay();
  GetParam().change(m);
  const auto faults = validate_materials({{"S", m}}, "/m");
  const std::string expected = GetParam().fault;
  if (expected.empty()) {
    EXPECT_TRUE(faults.empty()) << faults.front().pointer << " " << faults.front().message;
  } else {
    ASSERT_EQ(faults.size(), 1U);
    EXPECT_EQ(faults[0].pointer, expected) << faults[0].message;
  }
  const std::string warning = GetParam().warning;
  std::string told;
  for (const auto& line : warnings_of({{"S", m}})) told += line + "\n";
  if (expected.empty() && warning.empty()) {
    EXPECT_EQ(told, "");
  }
  EXPECT_NE(told.find(warning), std::string::npos) << told;
}

const Mistake mistakes[] = {
    {"none", [](Material&) {}, "", ""},
    {"Pa_for_kPa", [](Material& m) { m.peak_strength.constant_Pa = 40e6; },
     "/m/S/peak_strength_kPa", "Pa given for kPa"},
    {"rock_that_does_not_soften",
     [](Material& m) {
       m.softening.reset();
       m.peak_strength.constant_Pa = 40e6;
       m.shear_modulus_Pa = 4e9;
     },
     "", "above 1000 kPa is rock"},
    {"MPa_for_kPa",
     [](Material& m) {
       m.softening.reset();
       m.peak_strength.constant_Pa = 40;
     },
     "", "below 1 kPa"},
    {"modulus_in_MPa", [](Material& m) { m.shear_modulus_Pa = 4050; }, "/m/S/peak_strength_kPa",
     "MPa given for kPa"},
    {"modulus_in_Pa", [](Material& m) { m.shear_modulus_Pa = 4050e6; }, "/m/S/peak_strength_kPa",
     "Pa given for kPa"},
    {"modulus_of_rock",
     [](Material& m) {
       m.softening.reset();
       m.shear_modulus_Pa = 4050e6;
     },
     "", "Pa given for kPa"},
    {"tonnes", [](Material& m) { m.unit_weight = 1.7e3; }, "/m/S/unit_weight_kN_m3", ""},
    {"submerged", [](Material& m) { m.unit_weight = 9e3; }, "", "unit_weight_kN_m3 is 9"},
    {"strain_in_percent", [](Material& m) { urmi(m).residual_strain = 180; },
     "/m/S/softening/residual_strain", "as a fraction"},
    {"remolded_strain_in_percent", [](Material& m) { urmi(m).remolded_strain = 950; },
     "/m/S/softening/remolded_strain", "as a fraction"},
    {"beta_per_percent", [](Material& m) { urmi(m).beta = 0.028; }, "", "not per percent"},
    {"specimen_in_mm", [](Material& m) { m.softening->reference_size_m = 14; },
     "/m/S/softening/reference_size_m", "specimens"},
    {"radians",
     [](Material& m) {
       m.drained = DrainedStrength{0, 0.53};
     },
     "/m/S/drained/friction_angle_deg", "15 to 50 degrees"},
    {"k0_beyond_passive",
     [](Material& m) {
       m.drained = DrainedStrength{0, 30};
       m.k0 = 3.01;
     },
     "/m/S/k0", "passive ratio"},
    {"k0_held_by_cohesion",
     [](Material& m) {
       m.drained = DrainedStrength{5e3, 30};
       m.k0 = 3.5;
     },
     "", "more than the passive ratio of its drained strength (3)"},
    {"k0_far_beyond_passive",
     [](Material& m) {
       m.drained = DrainedStrength{5e3, 30};
       m.k0 = 10;
     },
     "/m/S/k0", "passive ratio"},
    {"k0_below_active",
     [](Material& m) {
       m.drained = DrainedStrength{0, 30};
       m.k0 = 0.2;
     },
     "", "less than the active ratio of its drained strength (0.33)"},
    {"remolded_in_MPa", [](Material& m) { urmi(m).remolded_strength_Pa = 0.5; },
     "/m/S/softening/remolded_strength_kPa", "0.07 to 3 kPa"},
    {"remolded_of_the_most_liquid_clay", [](Material& m) { urmi(m).remolded_strength_Pa = 5; }, "",
     "0.07 to 3 kPa"},
    {"remolded_of_saint_thuribe", [](Material& m) { urmi(m).remolded_strength_Pa = 70; }, "", ""},
    {"large_strain_strength_in_MPa",
     [](Material& m) {
       m.softening->law = DeySoftening{1e3, 0.1, 2, 0.5};
     },
     "/m/S/softening/large_strain_strength_kPa", "softening/large_strain_strength_kPa is 0.0005"},
    {"rate_of_the_laboratory",
     [](Material& m) {
       m.rate = SemiLogarithmicRate{0.1, 1.4e-5};
       m.remolded_rate = SemiLogarithmicRate{0.1, 1};
     },
     "", ""},
    {"rate_in_percent_an_hour",
     [](Material& m) {
       m.rate = SemiLogarithmicRate{0.1, 5};
     },
     "", "rate/reference_rate_per_s is 5: direct simple shear has 1.4e-5 1/s (5 %/h)"},
    {"rate_of_the_additive_law",
     [](Material& m) {
       m.rate = AdditivePowerRate{0.08, 0.5, 1};
     },
     "", ""},
    {"rate_that_is_none",
     [](Material& m) {
       m.rate = PowerRate{0.1, 5e3};
     },
     "/m/S/rate/reference_rate_per_s", "rate/reference_rate_per_s"},
    {"remolded_rate_that_is_none",
     [](Material& m) {
       m.remolded_rate = PowerRate{0.1, 1e-13};
     },
     "/m/S/rate/remolded/reference_rate_per_s", "fall cone"},
    {"viscosity_of_a_fit", [](Material& m) { m.flow = BinghamFlow{300}; }, "", ""},
    {"viscosity_in_kPa_s", [](Material& m) { m.flow = BinghamFlow{3e4}; }, "",
     "flow/viscosity_Pa_s is 30000"},
    {"viscosity_below_water", [](Material& m) { m.flow = BinghamFlow{2e-4}; },
     "/m/S/flow/viscosity_Pa_s", "0.007 to 0.2"},
    {"viscosity_of_a_glacier", [](Material& m) { m.flow = BinghamFlow{1e13}; },
     "/m/S/flow/viscosity_Pa_s", ""},
    {"consistency_of_a_glacier",
     [](Material& m) {
       m.flow = HerschelBulkleyFlow{1e7, 0.3};
     },
     "/m/S/flow/consistency_Pa_sn", "flow/consistency_Pa_sn"},
    {"k0_high", [](Material& m) { m.k0 = 5; }, "", "overconsolidated"},
};

INSTANTIATE_TEST_SUITE_P(Units, OddMaterial, testing::ValuesIn(mistakes),
                         [](const auto& one) { return std::string(one.param.name); });

TEST(OddSection, GroundLighterThanWaterIsRefusedWhereItIsWet) {
  Section s = test::bank();
  s.materials.at("crust").unit_weight = 9e3;
  const auto faults = validate(s, {});
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].pointer, "/materials/crust/unit_weight_kN_m3");
  EXPECT_NE(faults[0].message.find("not the submerged one"), std::string::npos);
  s.water_table->depth_m = 2.5;  // below the crust
  EXPECT_TRUE(validate(s, {}).empty());
}

TEST(OddSection, AColumnOrALensBetweenTwoGroundPointsIsLookedAt) {
  Section s = test::bank();
  s.ground = {{0, 20}, {80, 20}, {110, 5}, {140, 5}};
  s.materials["peat"] = s.materials.at("crust");
  s.materials.at("peat").unit_weight = 9e3;
  const auto floats = [&] {
    const auto faults = validate(s, {});
    return faults.size() == 1 && faults[0].pointer == "/materials/peat/unit_weight_kN_m3";
  };
  Section with_lens = s;
  s.columns = {{0, 40, s.layers}, {40, 60, {test::layer("peat")}}, {60, 140, s.layers}};
  s.layers.clear();
  EXPECT_TRUE(floats());
  s.water_table->depth_m = 25;
  EXPECT_TRUE(validate(s, {}).empty());
  s = with_lens;
  s.layers = {test::layer("clay"), test::layer("peat"), test::layer("clay")};
  s.layers[0].bottom = {{0, 12}, {140, 12}};
  s.layers[1].bottom = {{0, 12}, {40, 12}, {50, 9}, {60, 12}, {140, 12}};
  EXPECT_TRUE(floats());
}

TEST(OddSection, ScalesOfFluctuationBeyondCellsAndSectionAreTold) {
  Section s = test::bank();
  RunSettings settings;
  settings.resolution.cell_m = 1;
  const auto with = [&](RandomField field) {
    s.materials.at("clay").field = field;
    return warnings_of(s, settings);
  };
  EXPECT_TRUE(with({0.2, 20, 2}).empty());
  const auto told = with({0.2, 101, 1.9});
  ASSERT_EQ(told.size(), 2U);
  EXPECT_EQ(told[0],
            "material clay: field/horizontal_m is 101 m: longer than the section's length (100 m), "
            "within which the strength hardly varies");
  EXPECT_NE(told[1].find("field/vertical_m is 1.9 m"), std::string::npos);
  EXPECT_NE(told[1].find("a cell of at most 0.95 m follows it"), std::string::npos);
}

TEST(OddSection, AMaterialInNoLayerIsTold) {
  Section s = test::bank();
  s.materials["silt"] = s.materials.at("clay");
  const auto told = warnings_of(s, {});
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0], "material 'silt' is in no layer");
  Layer silt;
  silt.material = "silt";
  s.columns = {{0, 50, s.layers}, {50, 100, {silt}}};
  s.layers.clear();
  EXPECT_TRUE(warnings_of(s, {}).empty());
}

TEST(OddSection, WaterBelowTheBaseIsTold) {
  Section s = test::bank();
  s.water_table->depth_m = 25;
  const auto told = warnings_of(s, {});
  ASSERT_EQ(told.size(), 1U);
  EXPECT_NE(told[0].find("the section is dry"), std::string::npos);
}

TEST(Warnings, AreAddedOnce) {
  std::vector<std::string> warnings{"a"};
  add_new(warnings, {"b", "a", "b"});
  EXPECT_EQ(warnings, (std::vector<std::string>{"a", "b"}));
}

}  // namespace
}  // namespace leda
