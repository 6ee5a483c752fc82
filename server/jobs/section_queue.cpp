#include "server/jobs/section_queue.hpp"

#include <algorithm>

namespace leda::server {

using db::SectionState;

SectionQueue::SectionQueue(std::vector<db::SectionInLine> sections)
    : sections_(std::move(sections)) {
  for (const auto& section : sections_) counts_of(section).add(section.state);
}

void SectionQueue::set_state(std::size_t index, SectionState state) {
  auto& section = sections_.at(index);
  counts_of(section).change(section.state, state);
  section.state = state;
  if (state == SectionState::waiting) none_waits_before_ = std::min(none_waits_before_, index);
}

std::optional<std::size_t> SectionQueue::first_waiting() const {
  if (counts_.of(SectionState::waiting) == 0) return std::nullopt;
  while (sections_[none_waits_before_].state != SectionState::waiting) ++none_waits_before_;
  return none_waits_before_;
}

bool SectionQueue::any_running(std::size_t count) const {
  if (counts_.of(SectionState::running) == 0) return false;
  return std::any_of(sections_.begin(), sections_.begin() + static_cast<std::ptrdiff_t>(count),
                     [](const auto& section) { return section.state == SectionState::running; });
}

}  // namespace leda::server
