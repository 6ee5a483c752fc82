#pragma once
// A section of a job as JSON.

#include <filesystem>
#include <ios>
#include <nlohmann/json.hpp>
#include <string>

#include "db/records.hpp"
#include "server/operate/data_folder.hpp"

namespace leda::server {

/// One row of the table of sections: state, status, distances, cost. Every key in every row; null
/// where there is no value.
nlohmann::json section_row(const db::SectionRecord& section);

/// The row and beside it the profile before and after, crest and toe, screening, the whole result
/// and the end of the worker's log.
nlohmann::json section_detail(const db::SectionRecord& section, const DataFolder& data);

/// The end of a worker's log, from the start of a line; empty where there is none.
std::string end_of_log(const std::filesystem::path& file, std::streamoff most_bytes);

}  // namespace leda::server
