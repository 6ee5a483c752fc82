#include "server/commands/check_report.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace leda::server {
namespace {

using nlohmann::json;
using solver::Outcome;

/// Commas and quotes as RFC 4180 has them.
std::string quoted(const std::string& text) {
  std::string field = "\"";
  for (const char c : text) field += c == '"' ? std::string("\"\"") : std::string(1, c);
  return field + "\"";
}

std::string joined(const std::vector<std::string>& sentences) {
  return fmt::format("{}", fmt::join(sentences, "; "));
}

/// What a run measures of itself; of a refused case and of a bisection there is no distance.
bool has_distances(const Outcome& o) { return o.ran && !o.critical_number; }

json as_json(const Outcome& o) {
  json c{{"name", o.name},
         {"extreme", o.extreme},
         {"status", o.ran ? to_string(o.result.status) : "refused"},
         {"reason", o.ran ? o.result.reason : o.refusal},
         {"kept", o.kept()},
         {"broken", o.broken},
         {"finite", o.finite},
         {"run_time_s", o.run_time_s}};
  if (o.critical_number) c["critical_stability_number"] = *o.critical_number;
  if (!o.ran) return c;
  const Balances& b = o.result.balances;
  c["balances"] = {{"mass", b.mass}, {"momentum", b.momentum}, {"energy", b.energy}};
  c["steps"] = o.result.steps;
  c["particles"] = o.result.particles;
  c["simulated_s"] = o.result.simulated_s;
  c["warnings"] = o.result.warnings;
  if (!has_distances(o)) return c;
  c["retrogression_m"] = o.result.crest_to_crest_retrogression_m;
  c["runout_m"] = o.result.runout_m;
  c["slides"] = o.result.slides;
  return c;
}

}  // namespace

std::string outcome_in_a_word(const Outcome& o) {
  if (o.critical_number) return fmt::format("gH/su {:.2f}", *o.critical_number);
  return o.ran ? to_string(o.result.status) : "refused";
}

std::string check_header() {
  return fmt::format("{:<24} {:<56} {:<11} {:>6} {:>6} {:>8} {:>7} {:>7} {:>6} {:>8} {:>7}  {}\n",
                     "case", "what is extreme", "outcome", "R m", "L m", "energy", "mass", "mom.",
                     "finite", "steps", "time s", "promise");
}

std::string check_line(const Outcome& o) {
  const SectionResult& r = o.result;
  const auto if_ran = [&](bool has, const std::string& text) {
    return has ? text : std::string("-");
  };
  std::string line = fmt::format(
      "{:<24} {:<56} {:<11} {:>6} {:>6} {:>8} {:>7} {:>7} {:>6} {:>8} {:>7.1f}  {}\n", o.name,
      o.extreme, outcome_in_a_word(o),
      if_ran(has_distances(o), fmt::format("{:.1f}", r.crest_to_crest_retrogression_m)),
      if_ran(has_distances(o), fmt::format("{:.1f}", r.runout_m)),
      if_ran(o.ran, fmt::format("{:.2f} %", 100 * r.balances.energy)),
      if_ran(o.ran, fmt::format("{:.0e}", r.balances.mass)),
      if_ran(o.ran, fmt::format("{:.0e}", r.balances.momentum)), o.finite ? "yes" : "NO",
      if_ran(o.ran, std::to_string(r.steps)), o.run_time_s, o.kept() ? "kept" : "BROKEN");
  const std::string& why = o.ran ? r.reason : o.refusal;
  if (!why.empty()) line += "    " + why + "\n";
  for (const std::string& sentence : o.broken) line += "    ! " + sentence + "\n";
  return line;
}

json check_document(const std::vector<Outcome>& outcomes) {
  json cases = json::array();
  for (const Outcome& o : outcomes) cases.push_back(as_json(o));
  return {{"kept", std::ranges::all_of(outcomes, &Outcome::kept)}, {"cases", std::move(cases)}};
}

std::string check_csv(const std::vector<Outcome>& outcomes) {
  std::string csv =
      "name,extreme,status,reason,retrogression_m,runout_m,critical_stability_number,energy,mass,"
      "momentum,finite,steps,simulated_s,run_time_s,kept,broken\n";
  const auto if_there = [](bool there, double value) {
    return there ? fmt::format("{:.9g}", value) : std::string();
  };
  for (const Outcome& o : outcomes) {
    const SectionResult& r = o.result;
    const bool way = has_distances(o);
    csv += fmt::format(
        "{},{},{},{},{},{},{},{},{},{},{},{},{},{:.3f},{},{}\n", o.name, quoted(o.extreme),
        o.ran ? to_string(r.status) : "refused", quoted(o.ran ? r.reason : o.refusal),
        if_there(way, r.crest_to_crest_retrogression_m), if_there(way, r.runout_m),
        if_there(o.critical_number.has_value(), o.critical_number.value_or(0)),
        if_there(o.ran, r.balances.energy), if_there(o.ran, r.balances.mass),
        if_there(o.ran, r.balances.momentum), o.finite, r.steps, if_there(o.ran, r.simulated_s),
        o.run_time_s, o.kept(), quoted(joined(o.broken)));
  }
  return csv;
}

}  // namespace leda::server
