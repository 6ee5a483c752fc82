#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <variant>

#include "profiles/lay_out_sections.hpp"
#include "profiles/map_geometry.hpp"
#include "profiles/trace_profile.hpp"
#include "server/documents/json_syntax.hpp"
#include "server/documents/points.hpp"
#include "server/documents/region_readers.hpp"
#include "server/http/handlers/handlers.hpp"
#include "server/http/handlers/parameters.hpp"
#include "server/http/site.hpp"
#include "server/jobs/request_pointers.hpp"
#include "server/layers/rasters.hpp"
#include "server/operate/problem.hpp"

namespace leda::server {
namespace {

using nlohmann::json;

profiles::Dem open_dem(const Service& service, const std::string& id) {
  const auto raster = raster_or_problem(service.store, id);
  profiles::DemOptions options;
  options.missing_m = raster.undeclared_fill_m;
  return profiles::Dem::open(service.data.root() / raster.file, options);
}

/// {"inputs": {"sections": ...}}, as in a region request, so that faults have the same pointers.
SectionLayout read_layout(const json& document) {
  FaultList faults;
  SectionLayout layout;
  ObjectReader body(document, "", faults);
  if (const json* inputs = body.require("inputs")) {
    ObjectReader reader(*inputs, "/inputs", faults);
    if (const json* sections = reader.require("sections")) {
      layout = read_sections(*sections, "/inputs/sections", {}, faults);
    }
    reader.refuse_unknown();
  }
  body.refuse_unknown();
  const auto found = faults.take();
  if (!found.empty()) {
    throw Problem(Failure::invalid_request, "the layout cannot be understood", found);
  }
  return layout;
}

json row_of(const profiles::LaidSection& laid, const profiles::Dem& dem) {
  json row = {{"name", laid.name},
              {"line", laid.line < 0 ? json() : json(laid.line)},
              {"order_m", laid.line < 0 ? json() : json(laid.order)}};
  const auto cut = profiles::trace_profile(laid, dem);
  if (const auto* left_out = std::get_if<LeftOut>(&cut)) {
    row["trace"] = points(left_out->trace);
    row["reason"] = left_out->reason;
    return row;
  }
  const auto& profile = std::get<Profile>(cut);
  row["trace"] = points(profile.trace);
  row["profile"] = points(profile.ground);
  row["crest_m"] = {profile.bank.crest.x, profile.bank.crest.z};
  row["toe_m"] = {profile.bank.toe.x, profile.bank.toe.z};
  row["warnings"] = profile.warnings;
  return row;
}

/// "x,y" in the DEM's CRS.
MapPoint point_at(const Call& call) {
  const auto parts = list(call, "at");
  std::vector<double> numbers;
  for (const auto& part : parts) {
    double number = 0;
    const char* last = part.data() + part.size();
    const auto [end, error] = std::from_chars(part.data(), last, number);
    if (error == std::errc{} && end == last && std::isfinite(number)) numbers.push_back(number);
  }
  if (numbers.size() != 2 || parts.size() != 2) {
    throw Problem(Failure::invalid_parameter,
                  "at is '" + call.parameter("at").value_or("") + "': give X,Y in the DEM's CRS");
  }
  return {numbers[0], numbers[1]};
}

}  // namespace

Answer post_layout(Site& site, const Call& call) {
  const auto parsed = parse_json(call.read_body(site.limits.document_bytes));
  if (!parsed) throw Problem(Failure::invalid_request, "the body is no JSON", parsed.faults);
  const SectionLayout wanted = read_layout(*parsed.value);
  const db::Turns::Turn turn(site.pages);
  const auto dem = open_dem(site.service, call.captured[0]);
  profiles::LayoutLimits limits;
  limits.most_sections = site.service.limits.sections;
  auto layout = profiles::lay_out_sections(wanted, dem, limits);
  for (auto& fault : layout.faults) fault.pointer = layout_pointer(*parsed.value, fault.pointer);
  if (!layout.faults.empty()) {
    throw Problem(Failure::invalid_request, "the sections cannot be laid out on the DEM",
                  layout.faults);
  }
  json rows = json::array();
  for (const auto& laid : layout.sections) rows.push_back(row_of(laid, dem));
  Answer answer;
  answer.body = json{{"sections", std::move(rows)}}.dump();
  return answer;
}

Answer get_elevation(Site& site, const Call& call) {
  const MapPoint point = point_at(call);
  const auto ground = open_dem(site.service, call.captured[0]).sample(point);
  return json_answer({{"elevation_m", ground ? json(*ground) : json()}});
}

}  // namespace leda::server
