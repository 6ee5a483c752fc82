#pragma once
// The site file and the answer of screening, as JSON with the units in the names.

#include <nlohmann/json.hpp>
#include <string_view>

#include "server/documents/parsed.hpp"
#include "solver/screening/decide.hpp"
#include "solver/screening/site.hpp"

namespace leda::server {

/// A site: height_m, unit_weight_kN_m3, peak_strength_kPa, and what else is known of
/// slope_angle_deg, remolded_strength_kPa, peak_strain, softening {alpha, beta, residual_strain},
/// plasticity_index_percent, liquidity_index, preconsolidation_kPa. Strains are fractions, beta is
/// per unit strain. Every fault at once, each with its pointer.
Parsed<solver::Site> parse_site_file(std::string_view text);

/// Every number of a screening; what could not be had is null, and `reasons` says why after the
/// reasons of the decision.
nlohmann::json to_document(const solver::ScreeningResult& result);

}  // namespace leda::server
