#pragma once
// A section's row, with the result of its latest run beside it. Private to db/.

#include <string>

#include "db/database.hpp"
#include "db/records.hpp"

namespace leda::db {

/// SELECT ... FROM sections with the results and placements of the latest run; a WHERE follows.
/// section_from() reads its columns in this order.
const std::string& select_sections();
/// The same with empty texts for the ground before and after, which are most of a row.
const std::string& select_sections_without_ground();

SectionRecord section_from(Query& row);

/// The columns of results and placements, as a part of select_sections.
const std::string& result_columns();

/// Reads result_columns; both stay empty where the latest run has no result.
void read_result(Query& row, SectionRecord& section);

/// The state of a section. Throws StoreError where there is none of that id.
SectionState state_of_section(Database& database, std::int64_t section);

/// Books the outcome of the section's try under way, if there is one.
void close_run(Database& database, std::int64_t section, const char* outcome,
               const std::string& reason);

}  // namespace leda::db
