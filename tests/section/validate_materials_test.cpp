#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>

#include "solver/section/validate.hpp"
#include "tests/section/bank.hpp"

namespace leda {
namespace {

std::multiset<std::string> faults_of(const std::function<void(Material&)>& change,
                                     const std::string& name = "S") {
  Material material = test::softening_clay();
  change(material);
  std::multiset<std::string> found;
  for (const Fault& f : validate_materials({{name, material}}, "/m")) found.insert(f.pointer);
  return found;
}

UrmiSoftening& urmi(Material& m) { return std::get<UrmiSoftening>(m.softening->law); }

using Pointers = std::multiset<std::string>;

TEST(ValidateMaterials, SoundAndEmpty) {
  EXPECT_EQ(faults_of([](Material&) {}), Pointers{});
  EXPECT_EQ(validate_materials({}, "/materials").at(0).pointer, "/materials");
}

TEST(ValidateMaterials, EveryParameterAtOnce) {
  const Pointers expected{"/m/S/unit_weight_kN_m3",
                          "/m/S/shear_modulus_kPa",
                          "/m/S/poisson_ratio",
                          "/m/S/k0",
                          "/m/S/peak_strength_kPa",
                          "/m/S/drained/cohesion_kPa",
                          "/m/S/drained/friction_angle_deg"};
  EXPECT_EQ(faults_of([](Material& m) {
              m.unit_weight = 17e6;  // N/m3 typed where kN/m3 is asked
              m.shear_modulus_Pa = 0;
              m.poisson_ratio = 0.5;
              m.k0 = -0.5;
              m.peak_strength.constant_Pa = -1;
              m.drained = DrainedStrength{-1, 90};
            }),
            expected);
}

TEST(ValidateMaterials, NotANumberEverywhere) {
  EXPECT_EQ(faults_of([](Material& m) {
              m.unit_weight = m.shear_modulus_Pa = m.poisson_ratio = m.k0 = NAN;
              m.peak_strength.constant_Pa = NAN;
              urmi(m) = {NAN, NAN, NAN, NAN, NAN, NAN};
              m.softening->reference_size_m = NAN;
            }).size(),
            12U);
}

TEST(ValidateMaterials, NamesAreEscapedInPointers) {
  EXPECT_EQ(faults_of([](Material& m) { m.k0 = 0; }, "a/b~c"), Pointers{"/m/a~1b~0c/k0"});
}

TEST(ValidateMaterials, StrengthTables) {
  const auto with = [](std::vector<std::array<double, 2>> rows, Strength::By by) {
    return faults_of([&](Material& m) { m.peak_strength = {by, 0, std::move(rows)}; });
  };
  EXPECT_EQ(with({{2, 25e3}, {10, 25e3}, {20, 50e3}}, Strength::By::depth), Pointers{});
  EXPECT_EQ(with({}, Strength::By::depth), Pointers{"/m/S/peak_strength_kPa/at_depth_m"});
  EXPECT_EQ(
      with({{-2, 25e3}, {10, 0}, {10, 50e3}}, Strength::By::depth),
      (Pointers{"/m/S/peak_strength_kPa/at_depth_m/0/0", "/m/S/peak_strength_kPa/at_depth_m/1/1",
                "/m/S/peak_strength_kPa/at_depth_m/2/0"}));
  EXPECT_EQ(with({{-2, 25e3}, {-3, 25e3}}, Strength::By::elevation),
            Pointers{"/m/S/peak_strength_kPa/at_elevation_m/1/0"});
}

TEST(ValidateMaterials, FieldsOfStrength) {
  const auto with = [](RandomField field) {
    return faults_of([&](Material& m) { m.field = field; });
  };
  EXPECT_EQ(with({0.2, 20, 2}), Pointers{});
  EXPECT_EQ(with({1, 0.01, 1e5}), Pointers{});
  EXPECT_EQ(with({0, 20, 2}), Pointers{"/m/S/field/cov"});
  EXPECT_EQ(with({20, 20, 2}), Pointers{"/m/S/field/cov"}) << "per cent";
  EXPECT_EQ(with({NAN, 0, -2}),
            (Pointers{"/m/S/field/cov", "/m/S/field/horizontal_m", "/m/S/field/vertical_m"}));
  EXPECT_EQ(with({0.2, 1e6, 1e-3}), (Pointers{"/m/S/field/horizontal_m", "/m/S/field/vertical_m"}));
}

TEST(ValidateMaterials, GroundThatDrainsHasNoFieldOfItsPeakStrength) {
  EXPECT_EQ(faults_of([](Material& m) {
              m.softening.reset();
              m.drained = DrainedStrength{1e3, 30};
              m.drains = true;
              m.field = RandomField{0.2, 20, 2};
            }),
            Pointers{"/m/S/field"});
}

TEST(ValidateMaterials, UrmiStrengthsAreInOrder) {
  const Pointers remolded{"/m/S/softening/remolded_strength_kPa"};
  // 0.095 x 40 kPa = 3.8 kPa
  EXPECT_EQ(faults_of([](Material& m) { urmi(m).remolded_strength_Pa = 3.7e3; }), Pointers{});
  EXPECT_EQ(faults_of([](Material& m) { urmi(m).remolded_strength_Pa = 3.9e3; }), remolded);
  EXPECT_EQ(faults_of([](Material& m) { urmi(m).remolded_strength_Pa = 41e3; }), remolded);
  EXPECT_EQ(faults_of([](Material& m) {
              urmi(m).residual_strength_Pa = 10e3;
              urmi(m).remolded_strength_Pa = 9e3;
            }),
            Pointers{});
  EXPECT_EQ(faults_of([](Material& m) { urmi(m).residual_strength_Pa = 41e3; }),
            Pointers{"/m/S/softening/residual_strength_kPa"});
}

TEST(ValidateMaterials, UrmiOrderIsCheckedAgainstTheSmallestPeakOfATable) {
  EXPECT_EQ(faults_of([](Material& m) {
              m.peak_strength = {Strength::By::depth, 0, {{0, 60e3}, {5, 9e3}, {10, 60e3}}};
            }),
            Pointers{"/m/S/softening/remolded_strength_kPa"});
}

TEST(ValidateMaterials, UrmiRemoldedStrainLiesBeyondTheResidualStrain) {
  EXPECT_EQ(faults_of([](Material& m) { urmi(m).remolded_strain = 1.7; }),
            Pointers{"/m/S/softening/remolded_strain"});
  // Below 1 / 0.13 = 7.7 kPa the default of eq. 4-4 would lie before the residual strain.
  const auto soft = [](Material& m) {
    m.peak_strength.constant_Pa = 7e3;
    urmi(m).remolded_strength_Pa = 0.5e3;
  };
  EXPECT_EQ(faults_of(soft), Pointers{"/m/S/softening/remolded_strain"});
  EXPECT_EQ(faults_of([&](Material& m) {
              soft(m);
              urmi(m).remolded_strain = 10;
            }),
            Pointers{});
}

TEST(ValidateMaterials, OtherLaws) {
  const auto with = [](SofteningLaw law) {
    return faults_of([&](Material& m) { m.softening->law = law; });
  };
  const std::string at = "/m/S/softening/";
  EXPECT_EQ(with(EinavRandolphSoftening{1e3, 0.5}), Pointers{});
  EXPECT_EQ(with(EinavRandolphSoftening{41e3, 0}),
            (Pointers{at + "remolded_strength_kPa", at + "strain_95"}));
  EXPECT_EQ(with(ExponentialSoftening{1e3, 80}), Pointers{});
  EXPECT_EQ(with(ExponentialSoftening{0, -1}),
            (Pointers{at + "remolded_strength_kPa", at + "shape_factor"}));
  EXPECT_EQ(with(LinearSoftening{1e3, 2}), Pointers{});
  EXPECT_EQ(with(LinearSoftening{1e3, 0}), Pointers{at + "remolded_strain"});
  EXPECT_EQ(with(DeySoftening{5e3, 0.5, 10, 1e3}), Pointers{});
  EXPECT_EQ(with(DeySoftening{5e3, 0.5, 0.9, 6e3}),
            (Pointers{at + "large_strain", at + "large_strain_strength_kPa"}));
}

}  // namespace
}  // namespace leda
