#pragma once
// A job in one line: how far it is, and what came of it.

#include <cstddef>
#include <string>
#include <vector>

#include "db/records.hpp"

namespace leda::server {

/// How many sections are in a state.
std::size_t count(const std::vector<db::SectionRecord>& sections, db::SectionState state);

/// 0 to 99: 100 is for a job that is finished.
/// @param running_fraction sum over the running sections of the share that is done
int progress_percent(const std::vector<db::SectionRecord>& sections, double running_fraction);

/// "3 of 12 sections done, 2 running"
std::string progress_message(const std::vector<db::SectionRecord>& sections);

/// "12 sections: 9 with a result, 1 stable without a run, 1 left out, 1 failed"
std::string final_message(const std::vector<db::SectionRecord>& sections);

/// The run's status where there is a result, else the section's state.
std::string status_of(const db::SectionRecord& section);

}  // namespace leda::server
