#include "server/documents/screening_document.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>

#include "server/documents/json_syntax.hpp"
#include "server/documents/object_reader.hpp"
#include "server/documents/or_null.hpp"
#include "solver/screening/site_material.hpp"

namespace leda::server {
namespace {

using nlohmann::json;
using solver::FactorsOfSafety;
using solver::Site;

std::optional<double> thousandfold(const std::optional<double>& value) {
  if (!value) return std::nullopt;
  return 1000 * *value;
}

/// The range is checked only where the number could be read.
void check(FaultList& faults, ObjectReader& reader, const char* key,
           const std::optional<double>& value, double low, double high, const char* range) {
  if (!value || !std::isfinite(*value)) return;
  faults.within(reader.at(key), *value, *value > low && *value <= high, range);
}

/// An optional number above `low` and up to `high`.
std::optional<double> read_within(ObjectReader& reader, FaultList& faults, const char* key,
                                  double low, double high, const char* range) {
  const auto value = reader.optional_number(key);
  check(faults, reader, key, value, low, high, range);
  return value;
}

double read_positive(ObjectReader& reader, FaultList& faults, const char* key, const char* unit) {
  const double value = reader.number(key);
  if (std::isfinite(value)) faults.positive(reader.at(key), value, unit);
  return value;
}

solver::SiteSoftening read_softening(const json& value, const std::string& at, FaultList& faults) {
  ObjectReader reader(value, at, faults);
  solver::SiteSoftening softening;
  softening.alpha = read_positive(reader, faults, "alpha", "");
  softening.beta = read_positive(reader, faults, "beta", "per unit strain");
  softening.residual_strain = read_positive(reader, faults, "residual_strain", "as a fraction");
  reader.refuse_unknown();
  return softening;
}

void check_order(const Site& site, FaultList& faults) {
  if (site.softening && site.peak_strain && site.softening->residual_strain <= *site.peak_strain) {
    faults.add("/softening/residual_strain", show(site.softening->residual_strain) +
                                                 ": must be above the peak strain of " +
                                                 show(*site.peak_strain));
  }
}

Site read_site(const json& document, FaultList& faults) {
  ObjectReader reader(document, "", faults);
  Site site;
  if (reader.find("name")) reader.text("name");
  site.height_m = read_positive(reader, faults, "height_m", "m");
  site.unit_weight = 1000 * read_positive(reader, faults, "unit_weight_kN_m3", "kN/m3");
  site.peak_strength_Pa = 1000 * read_positive(reader, faults, "peak_strength_kPa", "kPa");
  site.slope_angle_deg =
      read_within(reader, faults, "slope_angle_deg", 0, 90, "above 0 and up to 90");
  site.remolded_strength_Pa = thousandfold(
      read_within(reader, faults, "remolded_strength_kPa", 0, largest_number, "above 0 kPa"));
  site.peak_strain = read_within(reader, faults, "peak_strain", 0, 1,
                                 "a fraction above 0 and up to 1 (6.5 % is 0.065)");
  if (const json* v = reader.find("softening")) {
    site.softening = read_softening(*v, reader.at("softening"), faults);
  }
  site.plasticity_index = read_within(reader, faults, "plasticity_index_percent", 0, 1000,
                                      "above 0 and up to 1000 per cent");
  if (site.plasticity_index) *site.plasticity_index /= 100;
  site.liquidity_index =
      read_within(reader, faults, "liquidity_index", -10, 100, "above -10 and up to 100");
  site.preconsolidation_Pa = thousandfold(
      read_within(reader, faults, "preconsolidation_kPa", 0, largest_number, "above 0 kPa"));
  reader.refuse_unknown();
  check_order(site, faults);
  return site;
}

/// kJ of J.
json thousandth_or_null(const std::optional<double>& value) {
  return value ? or_null(std::optional(*value * 1e-3)) : json();
}

json document_of(const FactorsOfSafety& f) {
  return {{"bishop", or_null(f.bishop)},
          {"spencer", or_null(f.spencer)},
          {"morgenstern_price", or_null(f.morgenstern_price)}};
}

json document_of(const std::vector<solver::Criterion>& criteria) {
  json list = json::array();
  for (const auto& c : criteria) {
    list.push_back({{"name", c.name}, {"met", c.met ? json(*c.met) : json()}, {"why", c.why}});
  }
  return list;
}

json document_of(const solver::RemoldingEnergies& e) {
  return {{"complete_curve", thousandth_or_null(e.complete_curve)},
          {"leroueil", thousandth_or_null(e.leroueil)},
          {"linear", thousandth_or_null(e.linear)},
          {"thesis_reading", thousandth_or_null(e.thesis_reading)}};
}

json document_of(const solver::EmpiricalRetrogression& r) {
  return {{"urmi_2023_thesis", or_null(r.urmi_2023_thesis)},
          {"urmi_2023_corrected", or_null(r.urmi_2023_corrected)},
          {"urmi_2023_corrected_range", or_null(r.urmi_2023_corrected_range)},
          {"quinn_2011", or_null(r.quinn_2011)},
          {"carson_lajoie_1981", or_null(r.carson_lajoie_1981)},
          {"mitchell_markell_1974", or_null(r.mitchell_markell_1974)},
          {"nve_1_15", or_null(r.nve_1_15)}};
}

void add_missing(json& reasons, const char* what, const FactorsOfSafety& factors) {
  if (factors.bishop) return;
  if (!factors.why_not.empty()) {
    reasons.push_back(std::string("factor_of_safety.") + what + " is null: " + factors.why_not);
  }
}

/// The decision's reasons first, then why each null is null.
json all_reasons(const solver::ScreeningResult& r) {
  json reasons = r.reasons;
  for (const auto& [what, why] : r.analytics.missing) {
    reasons.push_back(fmt::format("{} is null: {}", what, why));
  }
  add_missing(reasons, "drained", r.drained);
  add_missing(reasons, "undrained", r.undrained);
  add_missing(reasons, "undrained_toe_cut", r.undrained_toe_cut);
  return reasons;
}

json document_of_decision(const solver::ScreeningResult& r) {
  return {{"required_intact", r.required_intact},
          {"required_toe_cut", r.required_toe_cut},
          {"worst_intact", or_null(r.worst_intact)},
          {"worst_toe_cut", or_null(r.worst_toe_cut)},
          {"worst_at_rest", or_null(r.worst_at_rest)},
          {"toe_cut_m", r.toe_cut_m},
          {"sensitive", r.sensitive}};
}

}  // namespace

Parsed<Site> parse_site_file(std::string_view text) {
  auto parsed = parse_json(text);
  if (!parsed) return {std::nullopt, std::move(parsed.faults)};
  FaultList list;
  const Site site = read_site(*parsed.value, list);
  auto faults = list.take();
  add_new_faults(faults, solver::faults_of_clay(site));
  if (!faults.empty()) return {std::nullopt, std::move(faults)};
  return {site, {}};
}

json to_document(const solver::ScreeningResult& r) {
  const solver::Analytics& a = r.analytics;
  return {{"stability_number", or_null(a.stability_number)},
          {"sensitivity", or_null(a.sensitivity)},
          {"brittleness_index", or_null(a.brittleness_index)},
          {"peak_strain", or_null(a.peak_strain)},
          {"limit_state_energy_kJ_m3", thousandth_or_null(a.limit_state_energy)},
          {"potential_energy_kJ_m3", thousandth_or_null(a.potential_energy)},
          {"remolding_energy_kJ_m3", thousandth_or_null(a.remolding.complete_curve)},
          {"remolding_energy_by", document_of(a.remolding)},
          {"destruction_index", or_null(a.destruction_index)},
          {"criteria", document_of(a.criteria)},
          {"empirical_retrogression_m", document_of(a.retrogression)},
          {"factor_of_safety",
           {{"drained", document_of(r.drained)},
            {"undrained", document_of(r.undrained)},
            {"undrained_toe_cut", document_of(r.undrained_toe_cut)}}},
          {"decision", to_string(r.decision)},
          {"decision_numbers", document_of_decision(r)},
          {"reasons", all_reasons(r)}};
}

}  // namespace leda::server
