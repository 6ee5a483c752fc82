#include "server/layers/summary.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace leda::server {

using db::SectionState;

std::size_t count(const std::vector<db::SectionRecord>& sections, SectionState state) {
  return static_cast<std::size_t>(
      std::count_if(sections.begin(), sections.end(),
                    [state](const auto& section) { return section.state == state; }));
}

namespace {

std::size_t count_done(const std::vector<db::SectionRecord>& sections) {
  return sections.size() - count(sections, SectionState::waiting) -
         count(sections, SectionState::running);
}

}  // namespace

int progress_percent(const std::vector<db::SectionRecord>& sections, double running_fraction) {
  if (sections.empty()) return 0;
  const double done = static_cast<double>(count_done(sections)) + running_fraction;
  return std::clamp(static_cast<int>(100 * done / static_cast<double>(sections.size())), 0, 99);
}

std::string progress_message(const std::vector<db::SectionRecord>& sections) {
  return fmt::format("{} of {} sections done, {} running", count_done(sections), sections.size(),
                     count(sections, SectionState::running));
}

std::string final_message(const std::vector<db::SectionRecord>& sections) {
  std::string text =
      fmt::format("{} section{}: {} with a result", sections.size(),
                  sections.size() == 1 ? "" : "s", count(sections, SectionState::finished));
  const auto also = [&](SectionState state, const char* what) {
    if (const auto number = count(sections, state); number > 0) {
      text += fmt::format(", {} {}", number, what);
    }
  };
  also(SectionState::stable, "stable without a run");
  also(SectionState::left_out, "left out");
  also(SectionState::failed, "failed");
  return text;
}

std::string status_of(const db::SectionRecord& section) {
  return section.result ? to_string(section.result->status) : db::to_string(section.state);
}

}  // namespace leda::server
