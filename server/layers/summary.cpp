#include "server/layers/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace leda::server {

using db::SectionState;

std::size_t StateCounts::all() const {
  return std::accumulate(counts_.begin(), counts_.end(), std::size_t{0});
}

std::size_t StateCounts::done() const {
  return all() - of(SectionState::waiting) - of(SectionState::running);
}

int progress_percent(const StateCounts& sections, double running_fraction) {
  if (sections.all() == 0) return 0;
  const double done = static_cast<double>(sections.done()) + running_fraction;
  return std::clamp(static_cast<int>(100 * done / static_cast<double>(sections.all())), 0, 99);
}

std::string progress_message(const StateCounts& sections) {
  return fmt::format("{} of {} sections done, {} running", sections.done(), sections.all(),
                     sections.of(SectionState::running));
}

std::string final_message(const StateCounts& sections) {
  std::string text =
      fmt::format("{} section{}: {} with a result", sections.all(), sections.all() == 1 ? "" : "s",
                  sections.of(SectionState::finished));
  const auto also = [&](SectionState state, const char* what) {
    if (const auto number = sections.of(state); number > 0) {
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
