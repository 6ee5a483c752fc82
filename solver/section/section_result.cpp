#include "solver/section/section_result.hpp"

#include <array>
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

}  // namespace leda
