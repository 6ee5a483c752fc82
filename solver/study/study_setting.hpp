#pragma once
// What a study varies. A further axis is a member of StudySetting and a row of study_axes: order,
// equality, lines of settings and documents follow from the two.

#include <array>
#include <cstddef>
#include <type_traits>

namespace leda::solver {

struct StudySetting {
  double cell_m = 1;
  int particles_per_cell = 4;
  double time_step_factor = 0.65;  ///< of h / c_p, as RunSettings has it

  bool operator==(const StudySetting&) const = default;
};

enum class Finer { smaller, larger };

struct StudyAxis {
  const char* key;   ///< its member in documents
  const char* name;  ///< in words
  Finer finer;       ///< which values are the finer ones
  bool is_whole;     ///< its values are whole numbers
  double (*value)(const StudySetting&);
  void (*set)(StudySetting&, double);
};

template <auto Member>
constexpr StudyAxis study_axis(const char* key, const char* name, Finer finer) {
  using Value = std::remove_cvref_t<decltype(StudySetting{}.*Member)>;
  return {key,
          name,
          finer,
          std::is_integral_v<Value>,
          [](const StudySetting& s) { return static_cast<double>(s.*Member); },
          [](StudySetting& s, double value) { s.*Member = static_cast<Value>(value); }};
}

/// In the order in which they tell the finer of two settings.
inline constexpr std::array study_axes{
    study_axis<&StudySetting::cell_m>("cell_m", "cells", Finer::smaller),
    study_axis<&StudySetting::particles_per_cell>("particles_per_cell", "particles", Finer::larger),
    study_axis<&StudySetting::time_step_factor>("time_step_factor", "time step", Finer::smaller)};

/// By the first axis on which they differ; false where they are equal.
bool is_finer(const StudySetting& a, const StudySetting& b);

/// Whether they are on one line along the axis: equal on every other one.
bool are_in_line(const StudySetting& a, const StudySetting& b, const StudyAxis& along);

}  // namespace leda::solver
