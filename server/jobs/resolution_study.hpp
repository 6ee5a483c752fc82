#pragma once
// The process resolution-study: one section at many settings. Each run of the study is a
// section of the job, so it is queued, resumed and retried as any other.

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "server/jobs/process.hpp"

namespace leda::server {

/// @throws Problem with every fault of the document
std::unique_ptr<Work> open_study(const std::string& request, const Library& library);

/// The results of a finished job: the study as "json", "csv" or "svg".
std::string study_results(const db::JobRecord& job, const std::vector<db::SectionRecord>& sections,
                          std::string_view format);

}  // namespace leda::server
