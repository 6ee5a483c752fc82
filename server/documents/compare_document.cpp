#include "server/documents/compare_document.hpp"

#include <cmath>

#include "server/documents/result_document.hpp"

namespace leda::server {
namespace {

using nlohmann::json;

bool is_usable(const ComparedSection& s) {
  return s.result && s.result->status != RunStatus::unstable &&
         s.result->status != RunStatus::interrupted;
}

json line_of(const Polyline& line) {
  json out = json::array();
  for (const Point& p : line) out.push_back({p.x, p.z});
  return out;
}

/// What sections are compared by. A section that screening called stable has no result.
json numbers_of(const ComparedSection& s) {
  const SectionResult& r = *s.result;
  return {{"crest_to_crest_retrogression_m", r.crest_to_crest_retrogression_m},
          {"runout_m", r.runout_m},
          {"runout_from_crest_m", r.runout_from_crest_m},
          {"slides", r.slides},
          {"simulated_s", r.simulated_s},
          {"run_time_s", r.run_time_s}};
}

json document_of(const ComparedSection& s) {
  json out{{"name", s.name},
           {"state", s.state},
           {"crest_m", {s.crest.x, s.crest.z}},
           {"toe_m", {s.toe.x, s.toe.z}},
           {"bank_height_m", s.crest.z - s.toe.z},
           {"profile_before_m", line_of(s.ground)},
           {"screening", s.screening},
           {"result", nullptr}};
  if (!s.result) return out;
  out["result"] = to_document(*s.result);
  out["profile_after_m"] = out["result"]["profile_after_m"];
  out["result"].erase("profile_after_m");
  return out;
}

json difference(const ComparedSection& from, const ComparedSection& to) {
  json out{{"from", from.name},
           {"to", to.name},
           {"bank_height_m", (to.crest.z - to.toe.z) - (from.crest.z - from.toe.z)}};
  const bool both = is_usable(from) && is_usable(to);
  const json empty = numbers_of({{}, {}, {}, {}, {}, SectionResult{}, {}});
  const json a = both ? numbers_of(from) : empty;
  const json b = both ? numbers_of(to) : empty;
  for (const auto& [key, value] : a.items()) {
    const double change = b[key].get<double>() - value.get<double>();
    out[key] = both && std::isfinite(change) ? json(change) : json(nullptr);
  }
  return out;
}

}  // namespace

json compare_json(const std::vector<ComparedSection>& sections) {
  json out{{"sections", json::array()}, {"differences", json::array()}};
  for (const ComparedSection& s : sections) out["sections"].push_back(document_of(s));
  for (std::size_t i = 1; i < sections.size(); ++i) {
    out["differences"].push_back(difference(sections[0], sections[i]));
  }
  return out;
}

}  // namespace leda::server
