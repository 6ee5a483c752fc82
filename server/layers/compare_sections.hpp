#pragma once
// Sections of the store, made ready to be compared.

#include <string>
#include <vector>

#include "db/store.hpp"
#include "server/documents/compare_document.hpp"

namespace leda::server {

/// @throws Problem where the job or a section of it is not there
std::vector<db::SectionRecord> sections_or_problem(const db::Store& store, const std::string& job,
                                                   const std::vector<std::string>& names);

std::vector<ComparedSection> as_compared(const std::vector<db::SectionRecord>& sections);

}  // namespace leda::server
