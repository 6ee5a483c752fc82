#include "solver/section/section_result.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace leda {
namespace {

constexpr std::array<std::pair<RunStatus, const char*>, 6> names{{
    {RunStatus::stable, "stable"},
    {RunStatus::at_rest, "at-rest"},
    {RunStatus::time_limit, "time-limit"},
    {RunStatus::left_domain, "left-domain"},
    {RunStatus::unstable, "unstable"},
    {RunStatus::interrupted, "interrupted"},
}};

}  // namespace

const char* to_string(RunStatus status) {
  for (const auto& [value, name] : names) {
    if (value == status) return name;
  }
  return "unstable";
}

std::optional<RunStatus> run_status_from(const std::string& text) {
  for (const auto& [value, name] : names) {
    if (text == name) return value;
  }
  return std::nullopt;
}

const char* to_string(Bound bound) { return bound == Bound::measured ? "measured" : "lower-bound"; }

std::optional<Bound> bound_from(const std::string& text) {
  for (const Bound bound : {Bound::measured, Bound::lower_bound}) {
    if (text == to_string(bound)) return bound;
  }
  return std::nullopt;
}

void mark_lower_bounds(SectionResult& result) {
  const auto cut_short = [&](std::string_view distance) {
    return std::ranges::any_of(result.warnings, [&](const std::string_view warning) {
      return warning.ends_with(std::string(distance) + " is a lower bound");
    });
  };
  const bool ended = result.status == RunStatus::stable || result.status == RunStatus::at_rest;
  const auto mark = [](Bound& bound, bool low) { bound = low ? Bound::lower_bound : bound; };
  mark(result.retrogression_is, !ended || cut_short("retrogression"));
  mark(result.runout_is, !ended || cut_short("runout"));
}

bool reached_edge(const SectionResult& result) {
  return std::ranges::any_of(result.warnings, [](const std::string_view warning) {
    return warning.ends_with("is a lower bound");
  });
}

}  // namespace leda
