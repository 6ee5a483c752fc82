#pragma once
// Pages of sections and zones, found in SQL. Private to db/.

#include <string>

#include "db/database.hpp"
#include "db/store.hpp"

namespace leda::db {

/// JOIN and WHERE for a table of features, "sections" or "zones": ?1 the job, ?2 to ?5 the box,
/// ?6 the id, ?9 the box's east where it goes on beyond 180 degrees.
/// @param condition of the caller, ends with AND, or empty
/// @param in_order read in the order of ids, for a page; else as SQLite likes, for a count
std::string matches(const std::string& table, const PageFilter& filter,
                    const std::string& condition, bool in_order);

/// The same in the order of ids: ?7 the limit, ?8 the id that the page begins after.
std::string page_of(const std::string& table, const PageFilter& filter,
                    const std::string& condition);

/// Whether a filter may find anything: without a job, features of jobs that succeeded alone are
/// shown, and where there is none SQLite would read every row to find that out.
bool may_find(Database& database, const PageFilter& filter);

void bind_page(Query& query, const PageFilter& filter);

/// What the features of jobs that succeeded cover. @param condition ends with AND
Coverage coverage_of(Database& database, const std::string& table, const std::string& condition);

}  // namespace leda::db
