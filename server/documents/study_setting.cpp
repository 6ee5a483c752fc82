#include "server/documents/study_setting.hpp"

#include <fmt/format.h>

#include <cstdint>

namespace leda::server {

using solver::StudyRun;
using solver::StudySetting;

StudySetting own_setting(const CaseFile& of) {
  const RunSettings& s = of.settings;
  return {s.resolution.cell_m, s.resolution.particles_per_cell, s.time_step_factor};
}

CaseFile case_of(const CaseFile& of, const StudyRun& run) {
  CaseFile one = of;
  one.settings.resolution = {run.setting.cell_m, run.setting.particles_per_cell, run.seed};
  one.settings.time_step_factor = run.setting.time_step_factor;
  one.settings.output = Output{};
  return one;
}

std::string run_name(const CaseFile& of, const StudyRun& run) {
  const StudySetting& s = run.setting;
  const bool own_step = s.time_step_factor == of.settings.time_step_factor;
  return fmt::format("cell-{}-particles-{}{}-seed-{}", s.cell_m, s.particles_per_cell,
                     own_step ? "" : fmt::format("-step-{}", s.time_step_factor), run.seed);
}

std::string setting_name(const StudySetting& setting, bool with_step) {
  return fmt::format("{} m, {} particle{}{}", setting.cell_m, setting.particles_per_cell,
                     setting.particles_per_cell == 1 ? "" : "s",
                     with_step ? fmt::format(", step {}", setting.time_step_factor) : "");
}

nlohmann::json to_document(const StudySetting& setting) {
  nlohmann::json out;
  for (const auto& axis : solver::study_axes) {
    const double value = axis.value(setting);
    out[axis.key] =
        axis.is_whole ? nlohmann::json(static_cast<std::int64_t>(value)) : nlohmann::json(value);
  }
  return out;
}

}  // namespace leda::server
