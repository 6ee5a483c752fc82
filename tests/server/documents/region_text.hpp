#pragma once
// The region that tests start from: sound, with everything a region may hold.

#include <nlohmann/json.hpp>

namespace leda::test {

inline nlohmann::json region() {
  return nlohmann::json::parse(R"({"inputs": {
    "name": "sainte-monique", "dem": "sainte-monique",
    "sections": [
      {"name": "AA'", "line": [[0, 0], [300, 10]], "crest": [180, 6], "toe": [220, 8]},
      {"along": [[0, 0], [0, 1000]], "spacing_m": 50, "upslope_m": 250, "downslope_m": 100},
      {"name": "BB'", "line": [[0, 50], [150, 60], [300, 60]]}
    ],
    "soil": {"models": [
      {"name": "plain", "base_below_toe_m": 5, "water_table": {"depth_m": 1},
       "layers": [{"material": "crust", "thickness_m": 2}, {"material": "clay"}],
       "materials": {
         "crust": {"unit_weight_kN_m3": 18, "youngs_modulus_kPa": 10000, "poisson_ratio": 0.45,
                   "peak_strength_kPa": 90},
         "clay": {"unit_weight_kN_m3": 17, "shear_modulus_kPa": 4050, "poisson_ratio": 0.45,
                  "peak_strength_kPa": 40,
                  "softening": {"law": "exponential", "remolded_strength_kPa": 1,
                                "shape_factor": 80}}}},
      {"name": "terrace", "base_m": -2, "where": [[[0, 0], [50, 0], [50, 50]]],
       "layers": [{"material": "clay"}],
       "materials": {
         "clay": {"unit_weight_kN_m3": 17, "shear_modulus_kPa": 4050, "poisson_ratio": 0.45,
                  "peak_strength_kPa": {"at_elevation_m": [[0, 60], [20, 20]]}}}}
    ]},
    "trigger": {"kind": "undrained", "then_toe_cut_m": 3},
    "resolution": {"cell_m": 1.0, "particles_per_cell": 4},
    "damping": {"dynamic": 0.05}, "time_step_factor": 0.4,
    "stop": {"max_time_s": 60}, "output": {"frame_interval_s": 5},
    "screening": {"skip_stable": false}, "dryRun": true
  }})");
}

/// The smallest one: one soil model, one line.
inline nlohmann::json small_region() {
  nlohmann::json small = region();
  auto& inputs = small["inputs"];
  const auto model = inputs["soil"]["models"][0];
  inputs = {{"name", "small"},
            {"dem", "dem-0123456789ab"},
            {"sections", inputs["sections"][1]},
            {"soil", {{"layers", model["layers"]}, {"materials", model["materials"]}}},
            {"resolution", {{"cell_m", 1}}}};
  return small;
}

}  // namespace leda::test
