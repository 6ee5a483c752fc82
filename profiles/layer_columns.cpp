#include "profiles/layer_columns.hpp"

#include <string>

#include "profiles/dbf_text.hpp"

namespace leda::profiles {
namespace {

void set(OGRFeature& feature, int field, const std::string& value) {
  if (!value.empty()) feature.SetField(field, value.c_str());
}

void set(OGRFeature& feature, int field, double value) { feature.SetField(field, value); }
void set(OGRFeature& feature, int field, int value) { feature.SetField(field, value); }

template <class Value>
void set(OGRFeature& feature, int field, const std::optional<Value>& value) {
  if (value) set(feature, field, *value);
}

// A column whose value a function gives.
template <class Row, class Get>
Column<Row> column(const char* name, const char* short_name, OGRFieldType type, Get get) {
  return {name, short_name, type,
          [get](OGRFeature& feature, int field, const Row& row) { set(feature, field, get(row)); }};
}

template <class Row>
std::vector<Column<Row>> origin_columns(const RegionLayers& layers) {
  return {column<Row>("region", "region", OFTString, [n = layers.name](const Row&) { return n; }),
          column<Row>("job", "job", OFTString, [j = layers.job](const Row&) { return j; })};
}

}  // namespace

std::vector<Column<SectionFeature>> section_columns(const RegionLayers& layers,
                                                    std::size_t most_bytes) {
  using S = SectionFeature;
  auto columns = origin_columns<S>(layers);
  const auto add = [&](const char* name, const char* short_name, OGRFieldType type, auto get) {
    columns.push_back(column<S>(name, short_name, type, get));
  };
  add("name", "name", OFTString, [](const S& s) { return s.name; });
  add("line", "line", OFTInteger, [](const S& s) { return s.line; });
  add("order_m", "order_m", OFTReal, [](const S& s) { return s.order; });
  add("leda_status", "leda_stat", OFTString, [](const S& s) { return s.status; });
  add("leda_decision", "leda_decis", OFTString, [](const S& s) { return s.decision; });
  add("leda_reason", "leda_reas", OFTString,
      [most_bytes](const S& s) { return ended_within(s.reason, most_bytes); });
  add("leda_factor_of_safety", "leda_fos", OFTReal, [](const S& s) { return s.factor_of_safety; });
  add("leda_stability_number", "leda_ns", OFTReal, [](const S& s) { return s.stability_number; });
  add("leda_retrogression_m", "leda_ret_m", OFTReal, [](const S& s) { return s.retrogression_m; });
  add("leda_runout_m", "leda_run_m", OFTReal, [](const S& s) { return s.runout_m; });
  add("leda_runout_from_crest_m", "leda_rfc_m", OFTReal,
      [](const S& s) { return s.runout_from_crest_m; });
  add("leda_retrogression_is", "leda_ret_i", OFTString,
      [](const S& s) { return s.retrogression_is; });
  add("leda_runout_is", "leda_run_i", OFTString, [](const S& s) { return s.runout_is; });
  add("leda_slides", "leda_slid", OFTInteger, [](const S& s) { return s.slides; });
  add("leda_simulated_s", "leda_sim_s", OFTReal, [](const S& s) { return s.simulated_s; });
  add("leda_run_time_s", "leda_rt_s", OFTReal, [](const S& s) { return s.run_time_s; });
  add("leda_warnings", "leda_warn", OFTString,
      [most_bytes](const S& s) { return joined_within(s.warnings, "; ", most_bytes); });
  add("leda_made_by", "leda_hash", OFTString, [](const S& s) { return s.made_by; });
  return columns;
}

std::vector<Column<ProfilePoint>> profile_columns(const RegionLayers& layers) {
  using P = ProfilePoint;
  auto columns = origin_columns<P>(layers);
  columns.push_back(
      column<P>("section", "section", OFTString, [](const P& p) { return p.section->name; }));
  columns.push_back(
      column<P>("stage", "stage", OFTString, [](const P& p) { return std::string(p.stage); }));
  columns.push_back(column<P>("x_m", "x_m", OFTReal, [](const P& p) { return p.x_m; }));
  columns.push_back(
      column<P>("elevation_m", "elev_m", OFTReal, [](const P& p) { return p.elevation_m; }));
  return columns;
}

namespace {

std::optional<double> exceedance_of(const ZoneRow& row) {
  const auto& probability = row.zone->probability;
  return probability ? std::optional(probability->exceedance) : std::nullopt;
}

std::optional<int> members_of(const ZoneRow& row) {
  const auto& probability = row.zone->probability;
  return probability ? std::optional(probability->members) : std::nullopt;
}

std::string condition_of(const ZoneRow& row) {
  return row.zone->probability ? "conditional on a slide starting at the section" : "";
}

}  // namespace

std::vector<Column<ZoneRow>> zone_columns(const RegionLayers& layers, bool of_ensemble,
                                          std::size_t most_bytes) {
  using Z = ZoneRow;
  auto columns = origin_columns<Z>(layers);
  const auto add = [&](const char* name, const char* short_name, OGRFieldType type, auto get) {
    columns.push_back(column<Z>(name, short_name, type, get));
  };
  if (of_ensemble) {
    add("leda_kind", "leda_kind", OFTString,
        [](const Z& z) { return std::string(to_string(z.zone->kind)); });
    add("leda_exceedance", "leda_excd", OFTReal, exceedance_of);
    add("leda_members", "leda_membs", OFTInteger, members_of);
    add("leda_condition", "leda_cond", OFTString, condition_of);
  }
  add("leda_sections", "leda_sects", OFTString,
      [most_bytes](const Z& z) { return joined_within(z.zone->sections, ", ", most_bytes); });
  add("leda_section_count", "leda_count", OFTInteger,
      [](const Z& z) { return static_cast<int>(z.zone->sections.size()); });
  add("leda_largest_distance_m", "leda_max_m", OFTReal,
      [](const Z& z) { return z.zone->largest_distance_m; });
  add("leda_mean_distance_m", "leda_avg_m", OFTReal,
      [](const Z& z) { return z.zone->mean_distance_m; });
  add("leda_distance_is", "leda_dis_i", OFTString,
      [](const Z& z) { return std::string(to_string(z.zone->distance_is)); });
  add("leda_area_m2", "leda_area", OFTReal, [](const Z& z) { return z.area_m2; });
  add("leda_warnings", "leda_warn", OFTString,
      [most_bytes](const Z& z) { return joined_within(z.zone->warnings, "; ", most_bytes); });
  add("leda_made_by", "leda_hash", OFTString, [](const Z& z) { return z.zone->made_by; });
  return columns;
}

}  // namespace leda::profiles
