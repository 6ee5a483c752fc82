#pragma once
// A case that is simulated in moments.

#include <nlohmann/json.hpp>

namespace leda::tests {

inline nlohmann::json small_bank() {
  return nlohmann::json::parse(R"({
    "name": "bank", "ground": [[0, 10], [25, 10], [31, 4], [45, 4]], "base_m": 2,
    "layers": [{"material": "clay"}],
    "materials": {"clay": {"unit_weight_kN_m3": 17, "shear_modulus_kPa": 1000,
                           "poisson_ratio": 0.45, "peak_strength_kPa": 20,
                           "softening": {"law": "exponential", "remolded_strength_kPa": 1,
                                         "shape_factor": 8, "regularization": "none"}}},
    "trigger": {"kind": "undrained", "then_toe_cut_m": 3},
    "resolution": {"cell_m": 1, "particles_per_cell": 4}, "stop": {"max_time_s": 60}})");
}

}  // namespace leda::tests
