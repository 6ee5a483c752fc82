#include "solver/study/study_dependence.hpp"

#include <algorithm>
#include <cmath>

namespace leda::solver {
namespace {

using Settings = std::vector<SettingSummary>;
using Distance = std::optional<Spread> SettingSummary::*;

Dependence dependence_of(double metres, const std::vector<double>& means) {
  Dependence dependence{metres, {}, means.size()};
  double mean = 0;
  for (const double m : means) mean += m / static_cast<double>(means.size());
  if (mean > 0) dependence.share = metres / mean;
  return dependence;
}

std::optional<Dependence> in_line(const Settings& settings, const SettingSummary& through,
                                  const StudyAxis& along, Distance distance) {
  if (!through.is_compared()) return std::nullopt;
  std::vector<double> means;
  for (const SettingSummary& s : settings) {
    if (s.is_compared() && are_in_line(s.setting, through.setting, along)) {
      means.push_back((s.*distance)->mean);
    }
  }
  if (means.size() < 2) return std::nullopt;
  const auto [least, most] = std::minmax_element(means.begin(), means.end());
  return dependence_of(*most - *least, means);
}

/// sqrt(sum (n - 1) s^2 / sum (n - 1)) of settings with n runs and standard deviations s.
std::optional<Dependence> on_seed(const Settings& settings, Distance distance) {
  double squares = 0, freedom = 0;
  std::vector<double> means;
  for (const SettingSummary& s : settings) {
    const auto& spread = s.*distance;
    if (!s.is_compared() || !spread || !spread->standard_deviation) continue;
    const auto own = static_cast<double>(spread->count - 1);
    squares += own * *spread->standard_deviation * *spread->standard_deviation;
    freedom += own;
    means.push_back(spread->mean);
  }
  if (freedom == 0) return std::nullopt;
  return dependence_of(std::sqrt(squares / freedom), means);
}

void keep_larger(std::optional<Dependence>& kept, const std::optional<Dependence>& other) {
  if (other && (!kept || other->metres > kept->metres)) kept = other;
}

}  // namespace

void find_dependence(StudySummary& summary) {
  const Settings& settings = summary.settings;
  for (SettingSummary& s : summary.settings) {
    for (std::size_t i = 0; i < study_axes.size(); ++i) {
      s.dependence[i] = {in_line(settings, s, study_axes[i], &SettingSummary::retrogression_m),
                         in_line(settings, s, study_axes[i], &SettingSummary::runout_m)};
      keep_larger(summary.dependence[i].retrogression, s.dependence[i].retrogression);
      keep_larger(summary.dependence[i].runout, s.dependence[i].runout);
    }
  }
  summary.dependence_on_seed = {on_seed(settings, &SettingSummary::retrogression_m),
                                on_seed(settings, &SettingSummary::runout_m)};
}

}  // namespace leda::solver
