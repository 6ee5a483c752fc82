#include "server/documents/study_document.hpp"

#include <fmt/format.h>

#include <utility>

#include "server/documents/or_null.hpp"
#include "server/documents/study_setting.hpp"

namespace leda::server {
namespace {

using nlohmann::json;
using solver::Dependence;
using solver::DependenceByAxis;
using solver::DependenceOfDistances;
using solver::Measure;
using solver::RunError;
using solver::SettingSummary;
using solver::Spread;
using solver::StudyRun;

json to_json(const std::optional<Spread>& spread) {
  if (!spread) return nullptr;
  return {{"mean", spread->mean},
          {"standard_deviation", or_null(spread->standard_deviation)},
          {"min", spread->least},
          {"max", spread->most}};
}

/// @param metres what its number of metres is called
json to_json(const std::optional<Dependence>& dependence, const char* metres) {
  if (!dependence) return nullptr;
  return {{metres, dependence->metres},
          {"share", or_null(dependence->share)},
          {"settings", dependence->settings}};
}

json to_json(const DependenceOfDistances& of, const char* metres) {
  return {{"retrogression", to_json(of.retrogression, metres)},
          {"runout", to_json(of.runout, metres)}};
}

json to_json(const DependenceByAxis& by_axis) {
  json out;
  for (std::size_t i = 0; i < by_axis.size(); ++i) {
    out[solver::study_axes[i].key] = to_json(by_axis[i], "difference_m");
  }
  return out;
}

json setting_document(const SettingSummary& s) {
  json out = to_document(s.setting);
  out.update({{"runs", s.runs},
              {"runs_with_result", s.with_result},
              {"crest_to_crest_retrogression_m", to_json(s.retrogression_m)},
              {"runout_m", to_json(s.runout_m)},
              {"slides", to_json(s.slides)},
              {"simulated_s", to_json(s.simulated_s)},
              {"run_time_s", to_json(s.run_time_s)},
              {"cost_s", or_null(s.cost_s)},
              {"ns_per_particle_step", to_json(s.ns_per_particle_step)},
              {"energy_error", to_json(s.energy_error)},
              {"is_reference", s.is_reference},
              {"not_a_choice", s.not_a_choice},
              {"dependence", to_json(s.dependence)}});
  for (const Measure measure : solver::measures) {
    const auto& judged = s.by(measure);
    out["error"][solver::to_string(measure)] = {
        {"of_runs", to_json(judged.error)},
        {"mean_within", judged.mean_within},
        {"mean_and_spread_within", judged.mean_and_spread_within}};
  }
  return out;
}

json run_document(const CaseFile& of, const StudyRun& run, const RunError& error) {
  json out = to_document(run.setting);
  out.update({{"name", run_name(of, run)},
              {"seed", run.seed},
              {"status", run.result ? to_string(run.result->status) : "no-result"},
              {"reason", run.result ? run.result->reason : run.reason},
              {"retrogression_error", or_null(error.retrogression)},
              {"runout_error", or_null(error.runout)},
              {"error", or_null(error.of(Measure::both))}});
  if (!run.result) return out;
  const SectionResult& r = *run.result;
  out.update({{"crest_to_crest_retrogression_m", r.crest_to_crest_retrogression_m},
              {"runout_m", r.runout_m},
              {"runout_from_crest_m", r.runout_from_crest_m},
              {"retrogression_is", to_string(r.retrogression_is)},
              {"runout_is", to_string(r.runout_is)},
              {"trigger_used", r.trigger_used},
              {"slides", r.slides},
              {"simulated_s", r.simulated_s},
              {"run_time_s", r.run_time_s},
              {"steps", r.steps},
              {"particles", r.particles},
              {"ns_per_particle_step", r.ns_per_particle_step},
              {"energy_error", r.balances.energy},
              {"numerical_dissipation", r.numerical_dissipation},
              {"warnings", r.warnings},
              {"case_sha256", r.case_sha256},
              {"version", r.version}});
  return out;
}

json reference_document(const Study& study) {
  const auto& reference = study.summary.reference;
  if (!reference) return nullptr;
  json out{{"retrogression_m", or_null(reference->retrogression_m)},
           {"runout_m", or_null(reference->runout_m)},
           {"source", reference->source},
           {"setting", nullptr}};
  if (const auto index = study.summary.reference_index) {
    out["setting"] = to_document(study.summary.settings[*index].setting);
  }
  return out;
}

json fastest_document(const Study& study, Measure measure, std::optional<std::size_t> index) {
  if (!index) return nullptr;
  const SettingSummary& s = study.summary.settings[*index];
  json out = to_document(s.setting);
  out.update({{"cost_s", *s.cost_s},
              {"error", s.by(measure).error->mean},
              {"error_standard_deviation", or_null(s.by(measure).error->standard_deviation)}});
  return out;
}

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"') out += '"';
    out += c;
  }
  return out + '"';
}

std::string cell(const std::optional<double>& value) {
  return value ? fmt::format("{}", *value) : "";
}

}  // namespace

Study conclude(StudyFile asked, std::vector<StudyRun> runs, std::string date) {
  auto summary = solver::summarize(asked.question, runs);
  return {std::move(asked), std::move(runs), std::move(summary), std::move(date)};
}

json to_document(const Study& study) {
  json out{{"name", study.asked.name},
           {"section", study.asked.of.section.name},
           {"date", study.date},
           {"machine", study.asked.machine},
           {"wanted_error", study.asked.question.wanted_error},
           {"reference", reference_document(study)},
           {"seed_spread",
            {{"retrogression", or_null(study.summary.floor_retrogression)},
             {"runout", or_null(study.summary.floor_runout)}}},
           {"setting_scatter",
            {{"retrogression", or_null(study.summary.scatter_retrogression)},
             {"runout", or_null(study.summary.scatter_runout)}}},
           {"dependence", to_json(study.summary.dependence)},
           {"settings", json::array()},
           {"runs", json::array()},
           {"outcome", study_outcome(study)},
           {"warnings", study_warnings(study.asked, study.runs)}};
  out["dependence"]["seed"] = to_json(study.summary.dependence_on_seed, "standard_deviation_m");
  for (const Measure measure : solver::measures) {
    const auto& fastest = study.summary.fastest_by(measure);
    out["fastest_within_wanted_error"][solver::to_string(measure)] = {
        {"by_mean", fastest_document(study, measure, fastest.by_mean)},
        {"by_mean_and_spread", fastest_document(study, measure, fastest.by_mean_and_spread)}};
  }
  for (const auto& setting : study.summary.settings) {
    out["settings"].push_back(setting_document(setting));
  }
  for (std::size_t i = 0; i < study.runs.size(); ++i) {
    out["runs"].push_back(run_document(study.asked.of, study.runs[i], study.summary.errors[i]));
  }
  return out;
}

std::string study_csv(const Study& study) {
  std::string text;
  for (const auto& axis : solver::study_axes) text += fmt::format("{},", axis.key);
  text +=
      "seed,status,crest_to_crest_retrogression_m,runout_m,retrogression_is,runout_is,slides,"
      "simulated_s,run_time_s,steps,particles,ns_per_particle_step,energy_error,"
      "retrogression_error,runout_error,error,reason\r\n";
  for (std::size_t i = 0; i < study.runs.size(); ++i) {
    const StudyRun& run = study.runs[i];
    const RunError& error = study.summary.errors[i];
    for (const auto& axis : solver::study_axes) text += fmt::format("{},", axis.value(run.setting));
    text += fmt::format("{},", run.seed);
    if (run.result) {
      const SectionResult& r = *run.result;
      text +=
          fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},", to_string(r.status),
                      r.crest_to_crest_retrogression_m, r.runout_m, to_string(r.retrogression_is),
                      to_string(r.runout_is), r.slides, r.simulated_s, r.run_time_s, r.steps,
                      r.particles, r.ns_per_particle_step, r.balances.energy);
    } else {
      text += "no-result,,,,,,,,,,,,";
    }
    text += fmt::format("{},{},{},{}\r\n", cell(error.retrogression), cell(error.runout),
                        cell(error.of(Measure::both)),
                        quoted(run.result ? run.result->reason : run.reason));
  }
  return text;
}

}  // namespace leda::server
