#include "server/documents/case_file.hpp"

#include <gtest/gtest.h>

#include <random>

#include "disk/sha256.hpp"
#include "server/documents/simulate_request.hpp"
#include "server/documents/softening_names.hpp"
#include "tests/server/documents/read_data.hpp"

namespace leda::server {
namespace {

CaseFile parsed(const std::string& text) {
  auto result = parse_case_file(text);
  EXPECT_TRUE(result) << test::text(result.faults);
  return result ? *result.value : CaseFile{};
}

TEST(CaseFile, SainteMoniqueInSiUnits) {
  const CaseFile c = parsed(test::read_case("sainte-monique-AA.json"));
  EXPECT_EQ(c.section.ground.size(), 6U);
  EXPECT_EQ(c.section.ground[2], (Point{220, 5}));
  EXPECT_EQ(c.section.water_table->depth_m, 0.0);
  const Material& crust = c.section.materials.at("crust");
  EXPECT_DOUBLE_EQ(crust.youngs_modulus_Pa(), 10e6);
  EXPECT_FALSE(crust.softening);
  const Material& s1 = c.section.materials.at("S1");
  EXPECT_EQ(s1.unit_weight, 17e3);
  EXPECT_EQ(s1.shear_modulus_Pa, 4.05e6);
  EXPECT_EQ(s1.peak_strength.constant_Pa, 40.5e3);
  EXPECT_EQ(s1.drained->cohesion_Pa, 3.7e3);
  const auto& law = std::get<UrmiSoftening>(s1.softening->law);
  EXPECT_EQ(law.remolded_strength_Pa, 1e3);
  EXPECT_FALSE(law.residual_strength_Pa);
  EXPECT_FALSE(law.remolded_strain);
  EXPECT_EQ(s1.softening->regularization, Regularization::beta);
  EXPECT_EQ(c.section.materials.at("B1").peak_strength.constant_Pa, 55e3);
  EXPECT_EQ(std::get<UndrainedTrigger>(c.settings.trigger).then_toe_cut_m, 3.0);
  EXPECT_EQ(c.settings.damping.initial, 0.75);
  EXPECT_EQ(c.settings.damping.dynamic, 0.02);
  EXPECT_EQ(c.settings.resolution.cell_m, 0.5);
}

TEST(CaseFile, ColumnsComeAndGo) {
  auto document = nlohmann::json::parse(test::read_case("sainte-monique-AA.json"));
  const auto layers = document["layers"];
  document.erase("layers");
  document["columns"] = {{{"from_m", 0}, {"to_m", 222}, {"layers", layers}},
                         {{"from_m", 222}, {"to_m", 306}, {"layers", {{{"material", "crust"}}}}}};
  const CaseFile c = parsed(document.dump());
  ASSERT_EQ(c.section.columns.size(), 2U);
  EXPECT_TRUE(c.section.layers.empty());
  EXPECT_EQ(c.section.columns[0].layers.size(), 3U);
  EXPECT_EQ(c.section.columns[1].from_m, 222);
  EXPECT_EQ(c.section.columns[1].layers[0].material, "crust");
  EXPECT_EQ(to_document(c)["columns"], document["columns"]);
  EXPECT_FALSE(to_document(c).contains("layers"));
}

TEST(CaseFile, EveryKeyArrives) {
  const CaseFile c = parsed(test::read_case("every-key.json"));
  const auto& m = c.section.materials;
  EXPECT_EQ(c.section.layers[1].bottom.size(), 2U);
  EXPECT_EQ(c.section.layers[3].bottom_below_toe_m, 3.5);
  EXPECT_EQ(c.section.water_table->line.size(), 4U);
  EXPECT_EQ(c.section.toe, (Point{70, 5}));
  EXPECT_TRUE(m.at("crust").drains);
  EXPECT_FALSE(m.at("upper").drains);
  EXPECT_EQ(m.at("upper").peak_strength.by, Strength::By::depth);
  EXPECT_EQ(m.at("upper").softening->regularization, Regularization::whole_curve);
  EXPECT_EQ(std::get<UrmiSoftening>(m.at("upper").softening->law).remolded_strain, 9.1);
  EXPECT_EQ(std::get<SemiLogarithmicRate>(*m.at("upper").rate).per_decade, 0.11);
  EXPECT_EQ(std::get<PowerRate>(*m.at("upper").remolded_rate).reference_rate, 1.2);
  EXPECT_EQ(m.at("upper").tensile_strength_Pa, 4700);
  EXPECT_EQ(m.at("middle").peak_strength.by, Strength::By::elevation);
  EXPECT_EQ(m.at("middle").softening->regularization, Regularization::none);
  EXPECT_EQ(std::get<EinavRandolphSoftening>(m.at("middle").softening->law).strain_95, 0.7);
  EXPECT_EQ(std::get<ExponentialSoftening>(m.at("lower").softening->law).shape_factor, 80);
  EXPECT_EQ(m.at("lower").field->cov, 0.23);
  EXPECT_EQ(m.at("lower").field->horizontal_m, 31.5);
  EXPECT_EQ(m.at("lower").field->vertical_m, 2.6);
  EXPECT_FALSE(m.at("upper").field);
  EXPECT_EQ(std::get<LinearSoftening>(m.at("base").softening->law).remolded_strain, 2.3);
  EXPECT_EQ(std::get<DeySoftening>(m.at("spare").softening->law).large_strain, 20.3);
  EXPECT_EQ(std::get<ExcavationTrigger>(c.settings.trigger).polygon.size(), 4U);
  EXPECT_EQ(c.settings.resolution.seed, 9007199254740992U);
  EXPECT_EQ(c.settings.time_step_factor, 0.3);
  EXPECT_TRUE(c.settings.output.paraview);
}

TEST(CaseFile, ABandIsWrittenAsItIsRead) {
  auto document = nlohmann::json::parse(test::read_case("sainte-monique-AA.json"));
  for (const char* name : {"S1", "B1"}) {
    document["materials"][name]["softening"]["regularization"] = "band";
    document["materials"][name]["softening"]["band_m"] = 2.5;
  }
  const CaseFile c = parsed(document.dump());
  EXPECT_EQ(c.section.materials.at("S1").softening->regularization, Regularization::band);
  EXPECT_EQ(c.section.materials.at("S1").softening->band_m, 2.5);
  EXPECT_EQ(parsed(canonical_text(c)).section.materials.at("B1").softening->band_m, 2.5);
}

TEST(CanonicalText, IsAFixedPoint) {
  for (const char* name : {"sainte-monique-AA.json", "every-key.json", "small-bank.json"}) {
    const CaseFile first = parsed(test::read_case(name));
    const std::string text = canonical_text(first);
    const CaseFile second = parsed(text);
    EXPECT_EQ(canonical_text(second), text) << name;
    for (const auto& [material, m] : first.section.materials) {
      const Material& again = second.section.materials.at(material);
      EXPECT_EQ(m.shear_modulus_Pa, again.shear_modulus_Pa) << name << material;
      EXPECT_EQ(m.unit_weight, again.unit_weight) << name << material;
      EXPECT_EQ(m.peak_strength.table, again.peak_strength.table) << name << material;
    }
  }
}

TEST(CanonicalText, IsTheSameForDocumentsThatMeanTheSame) {
  const std::string text = test::read_case("small-bank.json");
  auto document = nlohmann::json::parse(text);
  document["damping"] = {{"dynamic", 0.02}};
  document["time_step_factor"] = 0.65;
  auto& clay = document["materials"]["clay"];
  clay["k0"] = 0.5;
  clay.erase("shear_modulus_kPa");
  clay["youngs_modulus_kPa"] = 2900;
  EXPECT_EQ(case_sha256(parsed(text)), case_sha256(parsed(document.dump(4))));
  document["stop"]["max_time_s"] = 5;
  EXPECT_NE(case_sha256(parsed(text)), case_sha256(parsed(document.dump())));
}

TEST(CanonicalText, HashIsOfTheText) {
  const CaseFile c = parsed(test::read_case("small-bank.json"));
  EXPECT_EQ(case_sha256(c), disk::sha256_of(canonical_text(c)));
}

TEST(PerKilo, GivesBackWhatWasRead) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 100'000; ++i) {
    const double kilo_value = double(random() % 10'000'000) / 1000.0;
    EXPECT_EQ(per_kilo(kilo_value * 1000), kilo_value);
    const double any = std::uniform_real_distribution<double>(1e-6, 1e6)(random);
    EXPECT_EQ(per_kilo(any * 1000) * 1000, any * 1000);
  }
}

TEST(SimulateRequest, HoldsACase) {
  const std::string text = test::read_case("small-bank.json");
  const auto request = parse_simulate_request(R"({"inputs": {"case": )" + text + "}}");
  ASSERT_TRUE(request) << test::text(request.faults);
  EXPECT_EQ(case_sha256(request.value->of), case_sha256(parsed(text)));
  EXPECT_FALSE(request.value->ensemble);
}

TEST(SimulateRequest, PointersStartAtTheCase) {
  auto document = nlohmann::json::parse(test::read_case("small-bank.json"));
  document["base_m"] = 50;
  document["materials"]["clay"]["k0"] = "half";
  const nlohmann::json body{{"inputs", {{"case", document}, {"extra", 1}}}, {"more", 2}};
  EXPECT_EQ(test::pointers(parse_simulate_request(body.dump()).faults),
            (std::multiset<std::string>{"/inputs/case/base_m", "/inputs/case/materials/clay/k0",
                                        "/inputs/extra", "/more"}));
  EXPECT_EQ(test::pointers(parse_simulate_request("{}").faults),
            (std::multiset<std::string>{"/inputs"}));
  EXPECT_EQ(test::pointers(parse_simulate_request("[]").faults), (std::multiset<std::string>{""}));
}

}  // namespace
}  // namespace leda::server
