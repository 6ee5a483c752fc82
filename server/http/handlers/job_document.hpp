#pragma once
// A job as OGC API - Processes writes it (statusInfo).

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "db/records.hpp"

namespace leda::server {

/// @param url of the service, for the links
nlohmann::json status_info(const db::JobStatus& job, const std::string& url);

}  // namespace leda::server
