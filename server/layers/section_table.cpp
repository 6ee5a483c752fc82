#include "server/layers/section_table.hpp"

#include <fmt/format.h>

#include "server/layers/summary.hpp"

namespace leda::server {

std::string section_table(const std::vector<db::SectionRecord>& sections) {
  std::string table = fmt::format("{:<12} {:<12} {:>15} {:>9} {:>11}  {}\n", "section", "status",
                                  "retrogression/m", "runout/m", "run time/s", "remark");
  for (const auto& section : sections) {
    std::string remark = section.reason;
    const auto& warnings = section.result ? section.result->warnings : section.warnings;
    if (remark.empty() && !warnings.empty()) remark = warnings.front();
    if (section.result) {
      table += fmt::format("{:<12} {:<12} {:>15.1f} {:>9.1f} {:>11.1f}  {}\n", section.name,
                           status_of(section), section.result->crest_to_crest_retrogression_m,
                           section.result->runout_m, section.result->run_time_s, remark);
    } else {
      table += fmt::format("{:<12} {:<12} {:>15} {:>9} {:>11}  {}\n", section.name,
                           status_of(section), "-", "-", "-", remark);
    }
  }
  return table;
}

}  // namespace leda::server
