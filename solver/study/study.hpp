#pragma once
// Error against run time: one section over cell sizes, particles per cell, time steps and seeds,
// and what the runs say together. In the spirit of thesis 5.4, which compares single runs; here
// every setting is repeated with other seeds, because a slide amplifies a shift of 1e-6 m to
// metres.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "solver/section/section_result.hpp"
#include "solver/study/study_setting.hpp"

namespace leda::solver {

struct RepeatedSetting {
  StudySetting setting;
  int seeds = 3;  ///< beside the regular lattice, which is seed 0

  bool operator==(const RepeatedSetting&) const = default;
};

/// A distance that is absent, or 0 in the finest runs, is not compared.
struct StudyReference {
  std::optional<double> retrogression_m;
  std::optional<double> runout_m;
  std::string source;
};

struct StudyQuestion {
  std::vector<RepeatedSetting> settings;
  std::optional<StudyReference> reference;  ///< absent: the finest setting whose runs all ended
  double wanted_error = 0.1;                ///< fraction
};

struct StudyRun {
  StudySetting setting;
  std::uint64_t seed = 0;
  std::optional<SectionResult> result;
  std::string reason;  ///< why there is no result
};

/// Over the runs of one setting.
struct Spread {
  std::size_t count = 0;
  double mean = 0;
  std::optional<double> standard_deviation;  ///< of the sample (n - 1); absent for a single run
  double least = 0, most = 0;
};

/// What an error is about. `both` is the larger of the two distances' errors.
enum class Measure { both, retrogression, runout };
inline constexpr std::array measures{Measure::both, Measure::retrogression, Measure::runout};

/// "both", "retrogression", "runout"
const char* to_string(Measure measure);

/// Relative to the reference; positive: too far. Absent where the distance is not compared.
struct RunError {
  std::optional<double> retrogression, runout;

  /// Without its sign.
  std::optional<double> of(Measure measure) const;
};

/// One setting against the wanted error, by one measure.
struct Judgement {
  std::optional<Spread> error;          ///< of the runs' errors without their signs
  bool mean_within = false;             ///< mean <= wanted
  bool mean_and_spread_within = false;  ///< mean + standard deviation <= wanted
};

/// How far a distance depends on something, over settings whose runs all ended.
struct Dependence {
  double metres = 0;
  std::optional<double> share;  ///< of the mean of these settings; absent where that is 0
  std::size_t settings = 0;
};

struct DependenceOfDistances {
  std::optional<Dependence> retrogression, runout;
};

/// Along each of study_axes, the largest difference between the means of settings that differ on
/// it alone; absent where fewer than two such settings came to rest.
using DependenceByAxis = std::array<DependenceOfDistances, study_axes.size()>;

struct SettingSummary {
  StudySetting setting;
  std::size_t runs = 0, with_result = 0;
  /// Of the runs with a usable result, that is any but an unstable one; absent where there is none.
  std::optional<Spread> retrogression_m, runout_m, slides, simulated_s, run_time_s;
  std::optional<Spread> ns_per_particle_step, energy_error;
  /// Mean run time with every run brought to the setting's fastest pace (ns per particle and
  /// step), s: what other programs took from the machine is left out as far as it can be seen.
  std::optional<double> cost_s;
  std::array<Judgement, measures.size()> judged;  ///< by Measure
  bool is_reference = false;
  std::string not_a_choice;     ///< why the setting is never named; empty: it may be
  DependenceByAxis dependence;  ///< over the settings in line with this one

  /// All of its runs ended, so that its means can stand beside those of others.
  bool is_compared() const { return is_reference || not_a_choice.empty(); }

  const Judgement& by(Measure measure) const { return judged[std::size_t(measure)]; }
};

/// The fastest settings (cost_s) within the wanted error, as indices of settings.
struct Fastest {
  std::optional<std::size_t> by_mean, by_mean_and_spread;
};

struct StudySummary {
  std::optional<StudyReference> reference;       ///< what the errors are relative to
  std::optional<std::size_t> reference_index;    ///< of its setting, where it is the finest one
  std::vector<RunError> errors;                  ///< one a run, in the order of the runs
  std::vector<SettingSummary> settings;          ///< in the order of the question
  std::array<Fastest, measures.size()> fastest;  ///< by Measure
  /// dependence_on_seed relative to the reference: an error below it is chance. So is one below
  /// cell_m, in which distances are read.
  std::optional<double> floor_retrogression, floor_runout;
  /// Standard deviation of the means of those settings relative to the reference; absent for a
  /// single one. Settings that agree better than this with the reference may do so by luck.
  std::optional<double> scatter_retrogression, scatter_runout;

  /// Of all lines along the axis the one with the largest difference.
  DependenceByAxis dependence;
  /// Standard deviation over seeds, pooled over the settings whose runs all ended.
  DependenceOfDistances dependence_on_seed;

  const Fastest& fastest_by(Measure measure) const { return fastest[std::size_t(measure)]; }
};

/// Every run of every setting, without results: coarse settings first, so that an interrupted study
/// leaves as many results as it can.
std::vector<StudyRun> study_runs(const std::vector<RepeatedSetting>& settings);

/// @pre every run belongs to one setting of the question
StudySummary summarize(const StudyQuestion& question, const std::vector<StudyRun>& runs);

/// The run's distances can be compared: a result stands and is not unstable.
bool is_usable(const StudyRun& run);

/// The slide ended within the model, so its distances are no lower bounds.
bool has_ended(const StudyRun& run);

}  // namespace leda::solver
