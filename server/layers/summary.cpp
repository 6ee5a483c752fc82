#include "server/layers/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "solver/section/warnings.hpp"

namespace leda::server {

using db::SectionState;

std::size_t StateCounts::all() const {
  return std::accumulate(counts_.begin(), counts_.end(), std::size_t{0});
}

std::size_t StateCounts::done() const {
  return all() - of(SectionState::waiting) - of(SectionState::running);
}

namespace {

std::string summary_of(const StateCounts& counts, const char* one, const char* left_out) {
  std::string text = fmt::format("{} {}{}: {} with a result", counts.all(), one,
                                 counts.all() == 1 ? "" : "s", counts.of(SectionState::finished));
  const auto also = [&](SectionState state, const char* what) {
    if (const auto number = counts.of(state); number > 0) {
      text += fmt::format(", {} {}", number, what);
    }
  };
  also(SectionState::stable, "stable without a run");
  also(SectionState::left_out, left_out);
  also(SectionState::failed, "failed");
  return text;
}

}  // namespace

int progress_percent(const JobCounts& counts, double running_fraction) {
  const auto all = static_cast<double>(counts.sections.all() + counts.members.all());
  if (all == 0) return 0;
  const auto done = static_cast<double>(counts.sections.done() + counts.members.done());
  return std::clamp(static_cast<int>(100 * (done + running_fraction) / all), 0, 99);
}

std::string progress_message(const JobCounts& counts) {
  const auto& [sections, members] = counts;
  std::string text = fmt::format("{} of {} sections", sections.done(), sections.all());
  if (members.all() > 0)
    text += fmt::format(" and {} of {} members", members.done(), members.all());
  return text + fmt::format(" done, {} running", counts.of(SectionState::running));
}

std::string final_message(const JobCounts& counts) {
  std::string text = summary_of(counts.sections, "section", "left out");
  if (counts.members.all() > 0) text += "; " + summary_of(counts.members, "member", "not needed");
  return text;
}

std::string status_of(const db::SectionRecord& section) {
  return section.result ? to_string(section.result->status) : db::to_string(section.state);
}

std::vector<std::string> warnings_of(const db::SectionRecord& section) {
  std::vector<std::string> warnings;
  if (section.result) add_new(warnings, section.result->warnings);
  add_new(warnings, section.warnings);
  if (section.placed && section.placed->known) add_new(warnings, section.placed->warnings);
  return warnings;
}

}  // namespace leda::server
