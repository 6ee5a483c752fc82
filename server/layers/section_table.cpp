#include "server/layers/section_table.hpp"

#include <fmt/format.h>

#include "server/documents/warning_lines.hpp"
#include "server/layers/summary.hpp"
#include "solver/section/gathered_warnings.hpp"

namespace leda::server {
namespace {

/// A lower bound is written ">12.0".
std::string distance(double metres, Bound is) {
  return fmt::format("{}{:.1f}", is == Bound::lower_bound ? ">" : "", metres);
}

std::vector<std::string> gathered_from(const std::vector<db::SectionRecord>& sections) {
  GatheredWarnings gathered;
  for (const auto& section : sections) gathered.add(section.name, warnings_of(section));
  return lines_of(gathered);
}

}  // namespace

std::string section_table(const std::vector<db::SectionRecord>& sections) {
  std::string table = fmt::format("{:<12} {:<12} {:>15} {:>9} {:>11}  {}\n", "section", "status",
                                  "retrogression/m", "runout/m", "run time/s", "reason");
  for (const auto& section : sections) {
    if (section.result) {
      const SectionResult& r = *section.result;
      table += fmt::format("{:<12} {:<12} {:>15} {:>9} {:>11.1f}  {}\n", section.name,
                           status_of(section),
                           distance(r.crest_to_crest_retrogression_m, r.retrogression_is),
                           distance(r.runout_m, r.runout_is), r.run_time_s, section.reason);
    } else {
      table += fmt::format("{:<12} {:<12} {:>15} {:>9} {:>11}  {}\n", section.name,
                           status_of(section), "-", "-", "-", section.reason);
    }
  }
  return table + warning_lines(gathered_from(sections));
}

}  // namespace leda::server
