#include "server/layers/compare_sections.hpp"

#include <fmt/format.h>

#include "server/operate/problem.hpp"

namespace leda::server {

std::vector<db::SectionRecord> sections_or_problem(const db::Store& store, const std::string& job,
                                                   const std::vector<std::string>& names) {
  if (!store.job_status(job)) throw Problem(Failure::no_such_job, "there is no job " + job);
  std::vector<db::SectionRecord> sections;
  for (const auto& name : names) {
    auto section = store.section(job, name);
    if (!section) {
      throw Problem(Failure::no_such_resource,
                    fmt::format("job {} has no section '{}'", job, name));
    }
    sections.push_back(std::move(*section));
  }
  return sections;
}

std::vector<ComparedSection> as_compared(const std::vector<db::SectionRecord>& sections) {
  std::vector<ComparedSection> compared;
  compared.reserve(sections.size());
  for (const auto& section : sections) {
    compared.push_back({section.name, db::to_string(section.state), section.ground, section.crest,
                        section.toe, section.result,
                        section.screening.empty()
                            ? nlohmann::json()
                            : nlohmann::json::parse(section.screening, nullptr, false)});
  }
  return compared;
}

}  // namespace leda::server
