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

struct Number {
  const char* key;
  double value;
  Bound is;
};

/// What sections are compared by. A section that screening called stable has no result.
std::vector<Number> numbers_of(const SectionResult& r) {
  return {{"crest_to_crest_retrogression_m", r.crest_to_crest_retrogression_m, r.retrogression_is},
          {"runout_m", r.runout_m, r.runout_is},
          {"runout_from_crest_m", r.runout_from_crest_m, r.runout_is},
          {"slides", double(r.slides), Bound::measured},
          {"simulated_s", r.simulated_s, Bound::measured},
          {"run_time_s", r.run_time_s, Bound::measured}};
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

/// Why two numbers have no difference; empty where they have one.
std::string why_unknown(const ComparedSection& s, const Number& number) {
  if (!is_usable(s)) return s.name + " has no usable result";
  if (number.is == Bound::lower_bound) return "that of " + s.name + " is a lower bound";
  return std::isfinite(number.value) ? "" : "that of " + s.name + " is not finite";
}

json difference(const ComparedSection& from, const ComparedSection& to) {
  json out{{"from", from.name},
           {"to", to.name},
           {"bank_height_m", (to.crest.z - to.toe.z) - (from.crest.z - from.toe.z)},
           {"unknown", json::object()}};
  const auto a = numbers_of(from.result.value_or(SectionResult{}));
  const auto b = numbers_of(to.result.value_or(SectionResult{}));
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::string why = why_unknown(from, a[i]);
    if (why.empty()) why = why_unknown(to, b[i]);
    out[a[i].key] = why.empty() ? json(b[i].value - a[i].value) : json();
    if (!why.empty()) out["unknown"][a[i].key] = why;
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
