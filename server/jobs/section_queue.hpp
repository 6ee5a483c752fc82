#pragma once
// The sections of an unfinished job, with their members, as the dispatcher keeps them: 16 bytes
// each. All else of a section is read from the store when its turn comes.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "db/records.hpp"
#include "server/layers/summary.hpp"

namespace leda::server {

class SectionQueue {
 public:
  SectionQueue() = default;
  /// @param sections by ordinal
  explicit SectionQueue(std::vector<db::SectionInLine> sections);

  std::size_t size() const { return sections_.size(); }
  std::int64_t id(std::size_t index) const { return sections_.at(index).id; }
  db::SectionState state(std::size_t index) const { return sections_.at(index).state; }
  const JobCounts& counts() const { return counts_; }

  void set_state(std::size_t index, db::SectionState state);

  /// The index of the first that waits; nothing where none does.
  std::optional<std::size_t> first_waiting() const;

  /// Whether one of the first `count` is running.
  bool any_running(std::size_t count) const;

 private:
  StateCounts& counts_of(const db::SectionInLine& section) {
    return section.is_member ? counts_.members : counts_.sections;
  }

  std::vector<db::SectionInLine> sections_;
  JobCounts counts_;
  mutable std::size_t none_waits_before_ = 0;
};

}  // namespace leda::server
