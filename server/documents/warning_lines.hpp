#pragma once

#include <string>
#include <vector>

namespace leda::server {

/// "warning: TEXT", a line each, for terminals.
std::string warning_lines(const std::vector<std::string>& warnings);

}  // namespace leda::server
