#pragma once
// The sections of a job as a table for a terminal.

#include <string>
#include <vector>

#include "db/records.hpp"

namespace leda::server {

/// One line a section: name, status, retrogression, runout, run time, reason; below them one a
/// warning, with the sections it is about.
std::string section_table(const std::vector<db::SectionRecord>& sections);

}  // namespace leda::server
