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

bool reached_edge(const SectionResult& result) {
  return std::ranges::any_of(result.warnings, [](const std::string_view warning) {
    return warning.ends_with("is a lower bound");
  });
}

}  // namespace leda
