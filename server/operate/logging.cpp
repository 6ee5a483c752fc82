#include "server/operate/logging.hpp"

#include <spdlog/sinks/stdout_color_sinks.h>

namespace leda::server {

void set_up_logging(bool quiet) {
  if (!spdlog::get("leda")) spdlog::set_default_logger(spdlog::stderr_color_mt("leda"));
  spdlog::set_pattern("time=%Y-%m-%dT%H:%M:%S.%eZ level=%l %v", spdlog::pattern_time_type::utc);
  spdlog::set_level(quiet ? spdlog::level::warn : spdlog::level::info);
}

std::string in_quotes(std::string_view text) {
  std::string safe = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') safe += '\\';
    safe += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? ' ' : c;
  }
  return safe + "\"";
}

}  // namespace leda::server
