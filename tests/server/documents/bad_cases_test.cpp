// A corpus of bad cases: each a change (RFC 6902) of a sound one, with all the faults it has. Both
// the readers and the published schema see each of them, and may not disagree.
#include <gtest/gtest.h>

#include "server/documents/case_file.hpp"
#include "server/documents/published_schema.hpp"
#include "tests/server/documents/read_data.hpp"

namespace leda::server {
namespace {

using nlohmann::json;

/// Whether the published schema can see the fault too.
enum class Schema { sees_it, cannot };

struct BadCase {
  const char* name;
  Schema schema;
  const char* change;
  std::multiset<std::string> expected;
};

void PrintTo(const BadCase& one, std::ostream* out) { *out << one.name; }

const BadCase corpus[] = {
    {"unknown_key",
     Schema::sees_it,
     R"([{"op": "add", "path": "/cells", "value": 1}])",
     {"/cells"}},
    {"rate_and_flow_laws",
     Schema::sees_it,
     R"([{"op": "add", "path": "/materials/S1/rate", "value":
           {"law": "power", "exponent": 1.5, "reference_rate_per_s": 0}},
         {"op": "add", "path": "/materials/S1/flow", "value":
           {"law": "herschel-bulkley", "consistency_Pa_sn": -1, "exponent": 4}},
         {"op": "add", "path": "/materials/B1/rate", "value":
           {"law": "semi-logarithmic", "per_decade": 0, "reference_rate_per_s": 1}},
         {"op": "add", "path": "/materials/B1/flow", "value":
           {"law": "bingham", "viscosity": 10}}])",
     {"/materials/S1/rate/exponent", "/materials/S1/rate/reference_rate_per_s",
      "/materials/S1/flow/consistency_Pa_sn", "/materials/S1/flow/exponent",
      "/materials/B1/rate/per_decade", "/materials/B1/flow/viscosity_Pa_s",
      "/materials/B1/flow/viscosity"}},
    {"unknown_rate_and_flow_laws",
     Schema::sees_it,
     R"([{"op": "add", "path": "/materials/S1/rate", "value": {"law": "linear"}},
         {"op": "add", "path": "/materials/S1/flow", "value": {"law": "newton"}}])",
     {"/materials/S1/rate/law", "/materials/S1/flow/law"}},
    {"unknown_keys_inside",
     Schema::sees_it,
     R"([{"op": "add", "path": "/stop/max_time", "value": 1},
         {"op": "add", "path": "/materials/S1/colour", "value": "blue"},
         {"op": "add", "path": "/materials/S1/softening/gamma", "value": 1}])",
     {"/stop/max_time", "/materials/S1/colour", "/materials/S1/softening/gamma"}},
    {"everything_missing",
     Schema::sees_it,
     R"([{"op": "replace", "path": "", "value": {}}])",
     {"/name", "/ground", "/base_m", "/layers", "/materials", "/resolution"}},
    {"no_object", Schema::sees_it, R"([{"op": "replace", "path": "", "value": [1]}])", {""}},
    {"wrong_types",
     Schema::sees_it,
     R"([{"op": "replace", "path": "/name", "value": 7},
         {"op": "replace", "path": "/ground/1", "value": [1]},
         {"op": "replace", "path": "/base_m", "value": "0"},
         {"op": "replace", "path": "/layers", "value": {}},
         {"op": "replace", "path": "/materials/B1", "value": null},
         {"op": "replace", "path": "/resolution/particles_per_cell", "value": 4.5},
         {"op": "replace", "path": "/stop", "value": 120}])",
     {"/name", "/ground/1", "/base_m", "/layers", "/materials/B1", "/resolution/particles_per_cell",
      "/stop"}},
    {"ground_empty",
     Schema::sees_it,
     R"([{"op": "replace", "path": "/ground", "value": []}])",
     {"/ground"}},
    {"ground_out_of_order",
     Schema::cannot,
     R"([{"op": "replace", "path": "/ground/2", "value": [100, 5]}])",
     {"/ground/2/0"}},
    {"huge_number",
     Schema::sees_it,
     R"([{"op": "replace", "path": "/base_m", "value": -1e300}])",
     {"/base_m"}},
    {"base_above_ground",
     Schema::cannot,
     R"([{"op": "replace", "path": "/base_m", "value": 5}])",
     {"/base_m"}},
    {"layers_empty",
     Schema::sees_it,
     R"([{"op": "replace", "path": "/layers", "value": []}])",
     {"/layers"}},
    {"columns_beside_layers",
     Schema::sees_it,
     R"([{"op": "add", "path": "/columns", "value": [{"from_m": 0, "to_m": 400,
          "layers": [{"material": "S1"}]}]}])",
     {"/columns"}},
    {"columns_with_a_gap_and_a_key_misspelt",
     Schema::sees_it,
     R"([{"op": "remove", "path": "/layers"},
         {"op": "add", "path": "/columns", "value": [
           {"from_m": 0, "to_m": 100, "layers": [{"material": "S1"}]},
           {"from": 110, "to_m": 400, "layers": [{"material": "B1"}]}]}])",
     {"/columns/1/from", "/columns/1/from_m"}},
    {"neither_layers_nor_columns",
     Schema::sees_it,
     R"([{"op": "remove", "path": "/layers"}])",
     {"/layers"}},
    {"layer_without_bottom",
     Schema::cannot,
     R"([{"op": "remove", "path": "/layers/0/thickness_m"}])",
     {"/layers/0"}},
    {"layer_with_two_bottoms",
     Schema::sees_it,
     R"([{"op": "add", "path": "/layers/0/bottom_m", "value": 19}])",
     {"/layers/0"}},
    {"layer_key_misspelt",
     Schema::sees_it,
     R"([{"op": "move", "from": "/layers/0/thickness_m", "path": "/layers/0/thickness"}])",
     {"/layers/0/thickness"}},
    {"layer_bottom_empty",
     Schema::sees_it,
     R"([{"op": "replace", "path": "/layers/1", "value": {"material": "S1", "bottom": []}}])",
     {"/layers/1/bottom"}},
    {"layers_cross",
     Schema::cannot,
     R"([{"op": "replace", "path": "/layers/0", "value": {"material": "crust", "bottom_m": 4}}])",
     {"/layers/1/bottom_m"}},
    {"material_not_defined",
     Schema::cannot,
     R"([{"op": "remove", "path": "/materials/B1"}])",
     {"/layers/2/material"}},
    {"no_modulus",
     Schema::sees_it,
     R"([{"op": "remove", "path": "/materials/S1/shear_modulus_kPa"}])",
     {"/materials/S1/shear_modulus_kPa"}},
    {"both_moduli",
     Schema::sees_it,
     R"([{"op": "add", "path": "/materials/S1/youngs_modulus_kPa", "value": 12000}])",
     {"/materials/S1/youngs_modulus_kPa"}},
    {"youngs_modulus_negative",
     Schema::sees_it,
     R"([{"op": "replace", "path": "/materials/crust/youngs_modulus_kPa", "value": -1}])",
     {"/materials/crust/youngs_modulus_kPa"}},
    {"poisson_ratio_minus_one",
     Schema::sees_it,
     R"([{"op": "replace", "path": "/materials/crust/poisson_ratio", "value": -1}])",
     {"/materials/crust/poisson_ratio"}},
    {"materials_out_of_range",
     Schema::sees_it,
     R"([{"op": "replace", "path": "/materials/S1/unit_weight_kN_m3", "value": 17000},
         {"op": "replace", "path": "/materials/S1/poisson_ratio", "value": 0.5},
         {"op": "replace", "path": "/materials/S1/k0", "value": 0},
         {"op": "replace", "path": "/materials/S1/drained", "value": {"cohesion_kPa": -1,
          "friction_angle_deg": 90}},
         {"op": "replace", "path": "/materials/S1/softening/beta", "value": 0}])",
     {"/materials/S1/unit_weight_kN_m3", "/materials/S1/poisson_ratio", "/materials/S1/k0",
      "/materials/S1/drained/cohesion_kPa", "/materials/S1/drained/friction_angle_deg",
      "/materials/S1/softening/beta"}},
    {"strengths_in_the_wrong_order",
     Schema::cannot,
     R"([{"op": "replace", "path": "/materials/S1/softening/remolded_strength_kPa", "value": 50},
         {"op": "replace", "path": "/materials/B1/softening/remolded_strength_kPa", "value": 6}])",
     {"/materials/S1/softening/remolded_strength_kPa",
      "/materials/B1/softening/remolded_strength_kPa"}},
    {"strength_is_text",
     Schema::sees_it,
     R"([{"op": "replace", "path": "/materials/S1/peak_strength_kPa", "value": "40"}])",
     {"/materials/S1/peak_strength_kPa"}},
    {"strength_table_both_ways",
     Schema::sees_it,
     R"([{"op": "replace", "path": "/materials/S1/peak_strength_kPa",
          "value": {"at_depth_m": [[1, 40]], "at_elevation_m": [[1, 40]]}}])",
     {"/materials/S1/peak_strength_kPa"}},
    {"strength_table_rows",
     Schema::sees_it,
     R"([{"op": "replace", "path": "/materials/S1/peak_strength_kPa",
          "value": {"at_depth_m": [[1, 40], [2], [3, -1]]}}])",
     {"/materials/S1/peak_strength_kPa/at_depth_m/1",
      "/materials/S1/peak_strength_kPa/at_depth_m/2/1"}},
    {"strength_table_empty",
     Schema::sees_it,
     R"([{"op": "replace", "path": "/materials/S1/peak_strength_kPa",
          "value": {"at_depth_m": []}}])",
     {"/materials/S1/peak_strength_kPa/at_depth_m"}},
    {"law_unknown",
     Schema::sees_it,
     R"([{"op": "replace", "path": "/materials/S1/softening/law", "value": "brittle"}])",
     {"/materials/S1/softening/law"}},
    {"law_of_another",
     Schema::sees_it,
     R"([{"op": "replace", "path": "/materials/S1/softening",
          "value": {"law": "linear", "remolded_strength_kPa": 1, "strain_95": 2}}])",
     {"/materials/S1/softening/remolded_strain", "/materials/S1/softening/strain_95"}},
    {"regularization_unknown",
     Schema::sees_it,
     R"([{"op": "add", "path": "/materials/S1/softening/regularization", "value": "gamma"}])",
     {"/materials/S1/softening/regularization"}},
    {"band_without_thickness",
     Schema::cannot,
     R"([{"op": "add", "path": "/materials/S1/softening/regularization", "value": "band"},
         {"op": "add", "path": "/materials/B1/softening/regularization", "value": "band"},
         {"op": "add", "path": "/materials/B1/softening/band_m", "value": 2}])",
     {"/materials/S1/softening/band_m"}},
    {"band_thickness_without_band",
     Schema::cannot,
     R"([{"op": "add", "path": "/materials/S1/softening/band_m", "value": 2}])",
     {"/materials/S1/softening/band_m"}},
    {"bands_of_two_thicknesses",
     Schema::cannot,
     R"([{"op": "add", "path": "/materials/S1/softening/regularization", "value": "band"},
         {"op": "add", "path": "/materials/B1/softening/regularization", "value": "band"},
         {"op": "add", "path": "/materials/S1/softening/band_m", "value": 3},
         {"op": "add", "path": "/materials/B1/softening/band_m", "value": 2}])",
     {"/materials/S1/softening/band_m"}},
    {"band_beside_another_regularization",
     Schema::cannot,
     R"([{"op": "add", "path": "/materials/B1/softening/regularization", "value": "band"},
         {"op": "add", "path": "/materials/B1/softening/band_m", "value": 2}])",
     {"/materials/S1/softening/regularization"}},
    {"cell_of_more_than_half_the_band",
     Schema::cannot,
     R"([{"op": "add", "path": "/materials/S1/softening/regularization", "value": "band"},
         {"op": "add", "path": "/materials/B1/softening/regularization", "value": "band"},
         {"op": "add", "path": "/materials/S1/softening/band_m", "value": 0.9},
         {"op": "add", "path": "/materials/B1/softening/band_m", "value": 0.9}])",
     {"/resolution/cell_m"}},
    {"rate_without_reference",
     Schema::sees_it,
     R"([{"op": "add", "path": "/materials/S1/rate",
          "value": {"law": "semi-logarithmic", "per_decade": 0.1}}])",
     {"/materials/S1/rate/reference_rate_per_s"}},
    {"remolded_rate_of_ground_that_keeps_its_peak",
     Schema::cannot,
     R"([{"op": "add", "path": "/materials/crust/rate",
          "value": {"law": "semi-logarithmic", "per_decade": 0.1, "reference_rate_per_s": 1.4e-5,
                    "remolded": {"law": "power", "exponent": 0.1, "reference_rate_per_s": 1}}}])",
     {"/materials/crust/rate/remolded"}},
    {"field_of_impossible_values",
     Schema::sees_it,
     R"([{"op": "add", "path": "/materials/S1/field",
          "value": {"cov": 20, "horizontal_m": 0, "vertical_m": -2}}])",
     {"/materials/S1/field/cov", "/materials/S1/field/horizontal_m",
      "/materials/S1/field/vertical_m"}},
    {"field_without_its_scales",
     Schema::sees_it,
     R"([{"op": "add", "path": "/materials/S1/field", "value": {"cov": 0.2, "theta_h": 20}}])",
     {"/materials/S1/field/horizontal_m", "/materials/S1/field/theta_h",
      "/materials/S1/field/vertical_m"}},
    {"field_that_is_a_number",
     Schema::sees_it,
     R"([{"op": "add", "path": "/materials/S1/field", "value": 0.2}])",
     {"/materials/S1/field"}},
    {"field_of_drained_ground",
     Schema::cannot,
     R"([{"op": "add", "path": "/materials/crust/drainage", "value": "drained"},
         {"op": "add", "path": "/materials/crust/field",
          "value": {"cov": 0.2, "horizontal_m": 20, "vertical_m": 2}}])",
     {"/materials/crust/field"}},
    {"tensile_strength_beyond_yield",
     Schema::cannot,
     R"([{"op": "add", "path": "/materials/crust/tensile_strength_kPa", "value": 181}])",
     {"/materials/crust/tensile_strength_kPa"}},
    {"drained_without_its_strength",
     Schema::cannot,
     R"([{"op": "add", "path": "/materials/crust/drainage", "value": "drained"},
         {"op": "remove", "path": "/materials/crust/drained"}])",
     {"/materials/crust/drainage"}},
    {"drained_clay_that_softens",
     Schema::cannot,
     R"([{"op": "add", "path": "/materials/S1/drainage", "value": "drained"}])",
     {"/materials/S1/softening"}},
    {"drainage_misspelt",
     Schema::sees_it,
     R"([{"op": "add", "path": "/materials/crust/drainage", "value": "dry"}])",
     {"/materials/crust/drainage"}},
    {"tension_of_drained_ground_beyond_its_cohesion",
     Schema::cannot,
     R"([{"op": "add", "path": "/materials/crust/drainage", "value": "drained"},
         {"op": "replace", "path": "/materials/crust/drained",
          "value": {"cohesion_kPa": 5, "friction_angle_deg": 45}},
         {"op": "add", "path": "/materials/crust/tensile_strength_kPa", "value": 5.1}])",
     {"/materials/crust/tensile_strength_kPa"}},
    {"water_both",
     Schema::sees_it,
     R"([{"op": "add", "path": "/water_table/line", "value": [[0, 1], [1, 1]]}])",
     {"/water_table"}},
    {"water_neither",
     Schema::sees_it,
     R"([{"op": "replace", "path": "/water_table", "value": {}}])",
     {"/water_table"}},
    {"water_null",
     Schema::sees_it,
     R"([{"op": "replace", "path": "/water_table", "value": null}])",
     {"/water_table"}},
    {"crest_and_toe",
     Schema::cannot,
     R"([{"op": "add", "path": "/crest_m", "value": [183, 30]},
         {"op": "add", "path": "/toe_m", "value": [400, 5]}])",
     {"/crest_m/1", "/toe_m/0"}},
    {"trigger_unknown",
     Schema::sees_it,
     R"([{"op": "replace", "path": "/trigger", "value": {"kind": "earthquake"}}])",
     {"/trigger/kind"}},
    {"trigger_cut_too_high",
     Schema::cannot,
     R"([{"op": "replace", "path": "/trigger/then_toe_cut_m", "value": 16.7}])",
     {"/trigger/then_toe_cut_m"}},
    {"trigger_key_of_the_other",
     Schema::sees_it,
     R"([{"op": "add", "path": "/trigger/polygon", "value": [[1, 1], [2, 1], [2, 2]]}])",
     {"/trigger/polygon"}},
    {"excavation_crosses",
     Schema::cannot,
     R"([{"op": "replace", "path": "/trigger", "value": {"kind": "excavation",
          "polygon": [[210, 4], [225, 20], [225, 4], [210, 20]]}}])",
     {"/trigger/polygon"}},
    {"resolution",
     Schema::sees_it,
     R"([{"op": "replace", "path": "/resolution", "value": {"cell_m": 0, "particles_per_cell": 5,
          "seed": -1}}])",
     {"/resolution/cell_m", "/resolution/particles_per_cell", "/resolution/seed"}},
    {"too_many_particles",
     Schema::cannot,
     R"([{"op": "replace", "path": "/resolution/cell_m", "value": 0.01}])",
     {"/resolution/cell_m"}},
    {"settings",
     Schema::sees_it,
     R"([{"op": "add", "path": "/damping", "value": {"initial": 1, "dynamic": -1}},
         {"op": "add", "path": "/time_step_factor", "value": 1.1},
         {"op": "replace", "path": "/stop/max_time_s", "value": 0},
         {"op": "add", "path": "/output", "value": {"frame_interval_s": -1, "paraview": 1}}])",
     {"/damping/initial", "/damping/dynamic", "/time_step_factor", "/stop/max_time_s",
      "/output/frame_interval_s", "/output/paraview"}},
    {"faults_of_every_kind_at_once",
     Schema::sees_it,
     R"([{"op": "add", "path": "/cells", "value": 1},
         {"op": "replace", "path": "/ground/3/1", "value": "low"},
         {"op": "replace", "path": "/layers/1/material", "value": "sand"},
         {"op": "replace", "path": "/materials/B1/softening/remolded_strength_kPa", "value": 99},
         {"op": "remove", "path": "/resolution/cell_m"}])",
     {"/cells", "/ground/3/1", "/layers/1/material",
      "/materials/B1/softening/remolded_strength_kPa", "/resolution/cell_m"}},
};

class BadCases : public testing::TestWithParam<BadCase> {};

json changed(const char* change) {
  return json::parse(test::read_case("sainte-monique-AA.json")).patch(json::parse(change));
}

TEST_P(BadCases, EachGivesAllItsFaults) {
  const auto parsed = parse_case_file(changed(GetParam().change).dump());
  EXPECT_FALSE(parsed);
  EXPECT_EQ(test::pointers(parsed.faults), GetParam().expected) << test::text(parsed.faults);
}

TEST_P(BadCases, ReadersAndSchemaAgree) {
  const json document = changed(GetParam().change);
  const auto seen = schema_faults(PublishedSchema::case_file, document);
  EXPECT_EQ(!seen.empty(), GetParam().schema == Schema::sees_it) << test::text(seen);
  // The readers said all of it themselves, in words for people.
  EXPECT_EQ(test::text(parse_case_file(document.dump()).faults).find("published schema"),
            std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Corpus, BadCases, testing::ValuesIn(corpus),
                         [](const auto& one) { return std::string(one.param.name); });

TEST(UnknownKey, IsToldWithEachKnownOneOnce) {
  const auto faults = parse_case_file(changed(R"([
    {"op": "add", "path": "/materials/S1/softening/regularization", "value": "none"},
    {"op": "add", "path": "/materials/S1/softening/gamma", "value": 1}])")
                                          .dump())
                          .faults;
  ASSERT_EQ(faults.size(), 1U) << test::text(faults);
  EXPECT_EQ(faults[0].message,
            "is not known here; known are: law, alpha, beta, residual_strain, "
            "remolded_strength_kPa, residual_strength_kPa, remolded_strain, reference_size_m, "
            "regularization, band_m");
}

TEST(UnknownKey, OfARateIsToldWithTheRemoldedPart) {
  const auto faults = parse_case_file(changed(R"([
    {"op": "add", "path": "/materials/S1/rate",
     "value": {"law": "power", "exponent": 0.1, "reference_rate_per_s": 1, "gamma": 1}}])")
                                          .dump())
                          .faults;
  ASSERT_EQ(faults.size(), 1U) << test::text(faults);
  EXPECT_EQ(faults[0].message,
            "is not known here; known are: law, exponent, reference_rate_per_s, remolded");
}

TEST(GoodCases, MatchTheSchema) {
  for (const char* name : {"sainte-monique-AA.json", "every-key.json", "small-bank.json"}) {
    const json document = json::parse(test::read_case(name));
    EXPECT_EQ(test::text(schema_faults(PublishedSchema::case_file, document)), "") << name;
    const auto canonical = json::parse(canonical_text(*parse_case_file(document.dump()).value));
    EXPECT_EQ(test::text(schema_faults(PublishedSchema::case_file, canonical)), "") << name;
  }
}

// Every member of a sound case in turn replaced by values of every type: what one of readers and
// schema takes, the other must not call broken.
void check_every_place(const json& whole, const json::json_pointer& at) {
  const json values[] = {nullptr, true, "text", -1, 2.5, json::array(), json::object()};
  for (const json& value : values) {
    json document = whole;
    document[at] = value;
    const auto seen = schema_faults(PublishedSchema::case_file, document);
    const auto faults = parse_case_file(document.dump()).faults;
    if (!seen.empty()) {
      EXPECT_FALSE(faults.empty()) << at.to_string() << " = " << value;
      EXPECT_EQ(test::text(faults).find("published schema"), std::string::npos)
          << at.to_string() << " = " << value << "\n"
          << test::text(faults);
    }
  }
  const json& here = whole[at];
  if (here.is_object()) {
    for (const auto& member : here.items()) check_every_place(whole, at / member.key());
  }
  if (here.is_array()) {
    for (std::size_t i = 0; i < here.size(); ++i) check_every_place(whole, at / i);
  }
}

TEST(GoodCases, EveryMemberReplacedByEveryTypeFindsReadersAndSchemaAgreed) {
  check_every_place(json::parse(test::read_case("every-key.json")), json::json_pointer(""));
}

}  // namespace
}  // namespace leda::server
