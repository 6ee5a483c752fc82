#include "solver/study/study.hpp"

#include <algorithm>
#include <cmath>

#include "solver/study/study_dependence.hpp"

namespace leda::solver {
namespace {

using Runs = std::vector<const StudyRun*>;

Runs runs_of(const StudySetting& setting, const std::vector<StudyRun>& runs) {
  Runs found;
  for (const StudyRun& run : runs) {
    if (run.setting == setting) found.push_back(&run);
  }
  return found;
}

std::optional<Spread> spread_of(const std::vector<double>& values) {
  if (values.empty()) return std::nullopt;
  Spread spread;
  spread.count = values.size();
  const auto n = static_cast<double>(values.size());
  for (const double v : values) spread.mean += v / n;
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  spread.least = *least;
  spread.most = *most;
  // Rounding of the sum must not put the mean outside of its values.
  spread.mean = std::clamp(spread.mean, spread.least, spread.most);
  double squares = 0;
  for (const double v : values) squares += (v - spread.mean) * (v - spread.mean);
  if (values.size() > 1) spread.standard_deviation = std::sqrt(squares / (n - 1));
  return spread;
}

template <class Value>
std::optional<Spread> spread_over(const Runs& runs, Value value) {
  std::vector<double> values;
  for (const StudyRun* run : runs) {
    if (is_usable(*run)) values.push_back(value(*run->result));
  }
  return spread_of(values);
}

bool all_ended(const Runs& runs) {
  return !runs.empty() &&
         std::ranges::all_of(runs, [](const StudyRun* run) { return has_ended(*run); });
}

std::optional<double> if_positive(double value) {
  return value > 0 ? std::optional(value) : std::nullopt;
}

void choose_reference(const StudyQuestion& question, const std::vector<StudyRun>& runs,
                      StudySummary& summary) {
  if (question.reference) {
    summary.reference = question.reference;
    return;
  }
  std::optional<std::size_t> finest;
  for (std::size_t i = 0; i < question.settings.size(); ++i) {
    const StudySetting& setting = question.settings[i].setting;
    if (!all_ended(runs_of(setting, runs))) continue;
    if (!finest || is_finer(setting, question.settings[*finest].setting)) finest = i;
  }
  if (!finest) return;
  SettingSummary& setting = summary.settings[*finest];
  setting.is_reference = true;
  setting.not_a_choice = "it is the reference itself";
  summary.reference_index = finest;
  summary.reference = StudyReference{if_positive(setting.retrogression_m->mean),
                                     if_positive(setting.runout_m->mean), "finest setting"};
}

RunError error_of(const StudyRun& run, const std::optional<StudyReference>& reference) {
  RunError error;
  if (!reference || !is_usable(run)) return error;
  const auto relative = [&](double value, const std::optional<double>& to) {
    return to ? std::optional((value - *to) / *to) : std::nullopt;
  };
  error.retrogression =
      relative(run.result->crest_to_crest_retrogression_m, reference->retrogression_m);
  error.runout = relative(run.result->runout_m, reference->runout_m);
  return error;
}

std::string why_not(const Runs& runs) {
  const auto without = std::ranges::count_if(runs, [](const auto* run) { return !run->result; });
  const auto unstable =
      std::ranges::count_if(runs, [](const auto* run) { return run->result && !is_usable(*run); });
  const auto at_edge = std::ranges::count_if(
      runs, [](const auto* run) { return is_usable(*run) && reached_edge(*run->result); });
  const auto going_on = std::ranges::count_if(runs, [](const auto* run) {
    return is_usable(*run) && !has_ended(*run) && !reached_edge(*run->result);
  });
  std::string text;
  const auto add = [&](std::ptrdiff_t number, const char* what) {
    if (number == 0) return;
    if (!text.empty()) text += ", ";
    text += std::to_string(number) + " of " + std::to_string(runs.size()) + " runs " + what;
  };
  add(without, "without a result");
  add(unstable, "unstable");
  add(at_edge, "at the model's edge");
  add(going_on, "not at rest at their end");
  return text;
}

/// A run without a pace counts as it is.
std::optional<double> cost_of(const Runs& runs, const std::optional<Spread>& pace) {
  const auto cost = spread_over(runs, [&](const SectionResult& r) {
    const double own = r.ns_per_particle_step;
    return own > 0 && pace->least > 0 ? r.run_time_s * pace->least / own : r.run_time_s;
  });
  return cost ? std::optional(cost->mean) : std::nullopt;
}

SettingSummary describe(const StudySetting& setting, const Runs& runs) {
  SettingSummary s;
  s.setting = setting;
  s.runs = runs.size();
  s.retrogression_m =
      spread_over(runs, [](const SectionResult& r) { return r.crest_to_crest_retrogression_m; });
  s.runout_m = spread_over(runs, [](const SectionResult& r) { return r.runout_m; });
  s.slides = spread_over(runs, [](const SectionResult& r) { return double(r.slides); });
  s.simulated_s = spread_over(runs, [](const SectionResult& r) { return r.simulated_s; });
  s.run_time_s = spread_over(runs, [](const SectionResult& r) { return r.run_time_s; });
  s.ns_per_particle_step =
      spread_over(runs, [](const SectionResult& r) { return r.ns_per_particle_step; });
  s.cost_s = cost_of(runs, s.ns_per_particle_step);
  s.energy_error = spread_over(runs, [](const SectionResult& r) { return r.balances.energy; });
  s.with_result = s.run_time_s ? s.run_time_s->count : 0;
  s.not_a_choice = why_not(runs);
  return s;
}

Judgement judge(const SettingSummary& s, const Runs& runs, const StudySummary& summary,
                double wanted, Measure measure) {
  std::vector<double> errors;
  for (const StudyRun* run : runs) {
    if (const auto error = error_of(*run, summary.reference).of(measure)) errors.push_back(*error);
  }
  Judgement j;
  j.error = spread_of(errors);
  if (!j.error || !s.not_a_choice.empty()) return j;
  j.mean_within = j.error->mean <= wanted;
  j.mean_and_spread_within =
      j.error->standard_deviation && j.error->mean + *j.error->standard_deviation <= wanted;
  return j;
}

std::optional<std::size_t> fastest(const std::vector<SettingSummary>& settings, Measure measure,
                                   bool Judgement::*within) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < settings.size(); ++i) {
    if (!(settings[i].by(measure).*within)) continue;
    if (!best || settings[i].cost_s < settings[*best].cost_s) best = i;
  }
  return best;
}

/// Relative to the reference.
std::optional<double> floor_of(const std::optional<Dependence>& on_seed,
                               const std::optional<double>& reference) {
  if (!on_seed || !reference) return std::nullopt;
  return on_seed->metres / *reference;
}

/// Of the means of the settings whose runs all ended, relative to the reference.
std::optional<double> scatter(const std::vector<SettingSummary>& settings,
                              std::optional<Spread> SettingSummary::*distance,
                              const std::optional<double>& reference) {
  std::vector<double> means;
  for (const SettingSummary& s : settings) {
    if (s.is_compared()) means.push_back((s.*distance)->mean);
  }
  const auto spread = spread_of(means);
  if (!reference || !spread || !spread->standard_deviation) return std::nullopt;
  return *spread->standard_deviation / *reference;
}

}  // namespace

const char* to_string(Measure measure) {
  switch (measure) {
    case Measure::both:
      return "both";
    case Measure::retrogression:
      return "retrogression";
    case Measure::runout:
      return "runout";
  }
  return "";
}

std::optional<double> RunError::of(Measure measure) const {
  std::optional<double> error;
  const auto add = [&](const std::optional<double>& part) {
    if (part) error = std::max(error.value_or(0), std::abs(*part));
  };
  if (measure != Measure::runout) add(retrogression);
  if (measure != Measure::retrogression) add(runout);
  return error;
}

bool is_usable(const StudyRun& run) {
  return run.result && run.result->status != RunStatus::unstable &&
         run.result->status != RunStatus::interrupted;
}

bool has_ended(const StudyRun& run) {
  return run.result && !reached_edge(*run.result) &&
         (run.result->status == RunStatus::at_rest || run.result->status == RunStatus::stable);
}

std::vector<StudyRun> study_runs(const std::vector<RepeatedSetting>& settings) {
  std::vector<RepeatedSetting> ordered = settings;
  std::ranges::stable_sort(
      ordered, [](const auto& a, const auto& b) { return is_finer(b.setting, a.setting); });
  std::vector<StudyRun> runs;
  for (const RepeatedSetting& repeated : ordered) {
    for (int seed = 0; seed <= repeated.seeds; ++seed) {
      runs.push_back({repeated.setting, static_cast<std::uint64_t>(seed), {}, ""});
    }
  }
  return runs;
}

StudySummary summarize(const StudyQuestion& question, const std::vector<StudyRun>& runs) {
  StudySummary summary;
  for (const RepeatedSetting& asked : question.settings) {
    summary.settings.push_back(describe(asked.setting, runs_of(asked.setting, runs)));
  }
  choose_reference(question, runs, summary);
  for (const StudyRun& run : runs) summary.errors.push_back(error_of(run, summary.reference));
  for (SettingSummary& s : summary.settings) {
    for (const Measure measure : measures) {
      s.judged[std::size_t(measure)] =
          judge(s, runs_of(s.setting, runs), summary, question.wanted_error, measure);
    }
  }
  for (const Measure measure : measures) {
    summary.fastest[std::size_t(measure)] = {
        fastest(summary.settings, measure, &Judgement::mean_within),
        fastest(summary.settings, measure, &Judgement::mean_and_spread_within)};
  }
  find_dependence(summary);
  if (summary.reference) {
    const auto& on_seed = summary.dependence_on_seed;
    summary.floor_retrogression =
        floor_of(on_seed.retrogression, summary.reference->retrogression_m);
    summary.floor_runout = floor_of(on_seed.runout, summary.reference->runout_m);
    summary.scatter_retrogression = scatter(summary.settings, &SettingSummary::retrogression_m,
                                            summary.reference->retrogression_m);
    summary.scatter_runout =
        scatter(summary.settings, &SettingSummary::runout_m, summary.reference->runout_m);
  }
  return summary;
}

}  // namespace leda::solver
