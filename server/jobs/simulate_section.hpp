#pragma once
// The process simulate-section: one case, without a map.

#include <memory>
#include <string>

#include "server/jobs/process.hpp"

namespace leda::server {

/// @throws Problem with every fault of the document
std::unique_ptr<Work> open_section(const std::string& request, const Library& library);

}  // namespace leda::server
