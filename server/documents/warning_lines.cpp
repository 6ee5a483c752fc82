#include "server/documents/warning_lines.hpp"

namespace leda::server {

std::string warning_lines(const std::vector<std::string>& warnings) {
  std::string lines;
  for (const std::string& warning : warnings) lines += "warning: " + warning + "\n";
  return lines;
}

}  // namespace leda::server
