// A study in words: for the terminal, and as "outcome" of study.json.
#include <fmt/format.h>

#include <algorithm>

#include "server/documents/study_document.hpp"
#include "server/documents/study_setting.hpp"
#include "server/documents/warning_lines.hpp"
#include "solver/section/gathered_warnings.hpp"
#include "solver/section/warnings.hpp"

namespace leda::server {
namespace {

using solver::Dependence;
using solver::DependenceOfDistances;
using solver::Measure;
using solver::SettingSummary;
using solver::Spread;

std::string percent(double fraction) { return fmt::format("{:.1f} %", 100 * fraction); }

/// "106.5 +- 1.2"
std::string short_form(const std::optional<Spread>& spread, double factor, int digits) {
  if (!spread) return "-";
  std::string mean = fmt::format("{:.{}f}", factor * spread->mean, digits);
  if (!spread->standard_deviation) return mean;
  return fmt::format("{} \u00b1 {:.{}f}", mean, factor * *spread->standard_deviation, digits);
}

const char* subject(Measure measure) {
  switch (measure) {
    case Measure::both:
      return "in retrogression and runout";
    case Measure::retrogression:
      return "in retrogression alone";
    case Measure::runout:
      return "in runout alone";
  }
  return "";
}

std::string best_of(const Study& study, Measure measure, std::optional<std::size_t> index) {
  if (!index) return "none";
  const SettingSummary& s = study.summary.settings[*index];
  return fmt::format("{} (error {}, {:.1f} s)", setting_name(study, s.setting),
                     percent(s.by(measure).error->mean), *s.cost_s);
}

std::string sentence(const Study& study, Measure measure) {
  const auto& fastest = study.summary.fastest_by(measure);
  std::string text =
      fmt::format("fastest setting within {} {}: {}", percent(study.asked.question.wanted_error),
                  subject(measure), best_of(study, measure, fastest.by_mean));
  if (fastest.by_mean_and_spread == fastest.by_mean) {
    return text + (fastest.by_mean ? ", with its spread over seeds too" : "");
  }
  return text +
         "; with its spread over seeds: " + best_of(study, measure, fastest.by_mean_and_spread);
}

std::string part(const char* what, const std::optional<double>& floor) {
  return fmt::format("{} {}", what, floor ? percent(*floor) : "unknown");
}

std::string scatter_sentence(const Study& study) {
  return fmt::format(
      "scatter between settings (standard deviation of their means): {}, {}; a setting that is "
      "nearer to the reference may be so by luck",
      part("retrogression", study.summary.scatter_retrogression),
      part("runout", study.summary.scatter_runout));
}

std::string floor_sentence(const Study& study) {
  return fmt::format(
      "spread over seeds (standard deviation): {}, {}; a smaller error is chance, and so is one "
      "below the cell size, in which distances are read",
      part("retrogression", study.summary.floor_retrogression),
      part("runout", study.summary.floor_runout));
}

/// "23.0 m (19.6 %)" where the unit is " m"
std::string short_form(const std::optional<Dependence>& dependence, const char* unit,
                       const char* absent) {
  if (!dependence) return absent;
  const auto& share = dependence->share;
  return fmt::format("{:.1f}{}{}", dependence->metres, unit,
                     share ? fmt::format(" ({})", percent(*share)) : "");
}

std::string dependence_of(const Study& study,
                          std::optional<Dependence> DependenceOfDistances::*distance) {
  const auto part_of = [&](const std::string& name, const DependenceOfDistances& of) {
    return name + " " + short_form(of.*distance, " m", "not compared");
  };
  std::string text;
  for (std::size_t i = 0; i < solver::study_axes.size(); ++i) {
    text += part_of(solver::study_axes[i].name, study.summary.dependence[i]) + ", ";
  }
  return text + part_of("seed", study.summary.dependence_on_seed);
}

std::string dependence_sentence(const Study& study) {
  return fmt::format(
      "the answer depends (largest difference of means along one axis, the others held; seed: "
      "standard deviation) in retrogression on {}; in runout on {}",
      dependence_of(study, &DependenceOfDistances::retrogression),
      dependence_of(study, &DependenceOfDistances::runout));
}

/// Of the first column, at least as wide as names without a time step need.
std::size_t width_of_names(const Study& study) {
  std::size_t width = 20;
  for (const SettingSummary& s : study.summary.settings) {
    width = std::max(width, setting_name(study, s.setting).size());
  }
  return width;
}

/// Under the columns of the two distances.
std::string dependence_rows(const Study& study, std::size_t width) {
  const auto row = [&](const std::string& name, const DependenceOfDistances& of) {
    return fmt::format("{:<{}}{:>5}  {:>16}{:>16}\n", "depends on " + name, width, "",
                       short_form(of.retrogression, "", "-"), short_form(of.runout, "", "-"));
  };
  std::string text;
  for (std::size_t i = 0; i < solver::study_axes.size(); ++i) {
    text += row(solver::study_axes[i].name, study.summary.dependence[i]);
  }
  return text + row("seed", study.summary.dependence_on_seed);
}

bool is_compared(const Study& study, Measure measure) {
  const auto& reference = study.summary.reference;
  if (!reference) return false;
  const bool retrogression = reference->retrogression_m.has_value();
  const bool runout = reference->runout_m.has_value();
  if (measure == Measure::both) return retrogression && runout;
  return measure == Measure::retrogression ? retrogression : runout;
}

}  // namespace

std::string setting_name(const Study& study, const solver::StudySetting& setting) {
  return setting_name(setting, tells_time_step(study.asked));
}

std::vector<std::string> study_outcome(const Study& study) {
  if (!study.summary.reference) {
    return {"nothing is compared: no setting has come to rest in all its runs"};
  }
  std::vector<std::string> sentences;
  for (const Measure measure : solver::measures) {
    if (is_compared(study, measure)) sentences.push_back(sentence(study, measure));
  }
  sentences.push_back(floor_sentence(study));
  sentences.push_back(scatter_sentence(study));
  sentences.push_back(dependence_sentence(study));
  return sentences;
}

std::vector<std::string> study_warnings(const StudyFile& asked,
                                        const std::vector<solver::StudyRun>& runs) {
  const bool with_step = tells_time_step(asked);
  GatheredWarnings gathered;
  for (const solver::StudyRun& run : runs) {
    const CaseFile of = case_of(asked.of, run);
    gathered.add(setting_name(run.setting, with_step),
                 run.result ? run.result->warnings : warnings_of(of.section, of.settings));
  }
  return lines_of(gathered, "; ");
}

std::string study_table(const Study& study) {
  const std::size_t width = width_of_names(study);
  std::string text =
      fmt::format("{:<{}}{:>5}  {:>16}{:>16}{:>17}{:>9}{:>17}  {}\n", "setting", width, "runs",
                  "retrogression m", "runout m", "run time s", "cost s", "error %", "");
  for (const SettingSummary& s : study.summary.settings) {
    text += fmt::format(
        "{:<{}}{:>5}  {:>16}{:>16}{:>17}{:>9}{:>17}  {}\n", setting_name(study, s.setting), width,
        s.runs, short_form(s.retrogression_m, 1, 1), short_form(s.runout_m, 1, 1),
        short_form(s.run_time_s, 1, 1), s.cost_s ? fmt::format("{:.1f}", *s.cost_s) : "-",
        short_form(s.by(Measure::both).error, 100, 1), s.not_a_choice);
  }
  text += dependence_rows(study, width);
  for (const std::string& one : study_outcome(study)) text += one + "\n";
  return text + warning_lines(study_warnings(study.asked, study.runs));
}

}  // namespace leda::server
