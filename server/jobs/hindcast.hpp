#pragma once
// The process hindcast: what past slides teach. The runs of all waves are the job's sections; a
// wave is drawn from the results of those before, and waits for them.

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "server/jobs/process.hpp"

namespace leda::server {

/// @throws Problem with every fault of the document
std::unique_ptr<Work> open_hindcast(const std::string& request, const Library& library);

/// The results of a finished job: the hindcast as "json", its runs as "csv", or a drawing as "svg".
std::string hindcast_results(const db::JobRecord& job,
                             const std::vector<db::SectionRecord>& sections,
                             std::string_view format);

}  // namespace leda::server
