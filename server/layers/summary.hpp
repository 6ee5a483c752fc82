#pragma once
// A job in one line: how far it is, and what came of it.

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "db/records.hpp"

namespace leda::server {

/// How many sections of a job are in each state.
class StateCounts {
 public:
  void add(db::SectionState state) { ++at(state); }
  void change(db::SectionState from, db::SectionState to) {
    --at(from);
    ++at(to);
  }
  std::size_t of(db::SectionState state) const { return counts_[static_cast<std::size_t>(state)]; }
  std::size_t all() const;
  std::size_t done() const;  ///< neither waiting nor running

 private:
  std::size_t& at(db::SectionState state) { return counts_[static_cast<std::size_t>(state)]; }

  std::array<std::size_t, static_cast<std::size_t>(db::SectionState::dismissed) + 1> counts_{};
};

/// The rows of a job: its sections, and the members of their ensembles.
struct JobCounts {
  StateCounts sections, members;

  std::size_t of(db::SectionState state) const { return sections.of(state) + members.of(state); }
};

/// 0 to 99: 100 is for a job that is finished.
/// @param running_fraction sum over what runs of the share that is done
int progress_percent(const JobCounts& counts, double running_fraction);

/// "3 of 12 sections done, 2 running"; "12 of 12 sections and 70 of 768 members done, 2 running"
std::string progress_message(const JobCounts& counts);

/// "12 sections: 9 with a result, 1 stable without a run, 1 left out, 1 failed"; with members
/// "; 704 members: 500 with a result, 204 not needed"
std::string final_message(const JobCounts& counts);

/// The run's status where there is a result, else the section's state.
std::string status_of(const db::SectionRecord& section);

/// All there is to be told of it, each once: of its run, of its profile, of its place on the map.
std::vector<std::string> warnings_of(const db::SectionRecord& section);

}  // namespace leda::server
