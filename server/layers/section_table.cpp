#include "server/layers/section_table.hpp"

#include <fmt/format.h>

#include "server/layers/summary.hpp"

namespace leda::server {
namespace {

/// A lower bound is written ">12.0".
std::string distance(double metres, Bound is) {
  return fmt::format("{}{:.1f}", is == Bound::lower_bound ? ">" : "", metres);
}

std::string remark_of(const db::SectionRecord& section) {
  if (!section.reason.empty()) return section.reason;
  const auto& warnings = section.result ? section.result->warnings : section.warnings;
  return warnings.empty() ? "" : warnings.front();
}

}  // namespace

std::string section_table(const std::vector<db::SectionRecord>& sections) {
  std::string table = fmt::format("{:<12} {:<12} {:>15} {:>9} {:>11}  {}\n", "section", "status",
                                  "retrogression/m", "runout/m", "run time/s", "remark");
  for (const auto& section : sections) {
    const std::string remark = remark_of(section);
    if (section.result) {
      const SectionResult& r = *section.result;
      table += fmt::format("{:<12} {:<12} {:>15} {:>9} {:>11.1f}  {}\n", section.name,
                           status_of(section),
                           distance(r.crest_to_crest_retrogression_m, r.retrogression_is),
                           distance(r.runout_m, r.runout_is), r.run_time_s, remark);
    } else {
      table += fmt::format("{:<12} {:<12} {:>15} {:>9} {:>11}  {}\n", section.name,
                           status_of(section), "-", "-", "-", remark);
    }
  }
  return table;
}

}  // namespace leda::server
