#include "server/logging.hpp"

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

namespace leda::server {

void set_up_logging(bool quiet) {
  if (!spdlog::get("leda")) spdlog::set_default_logger(spdlog::stderr_color_mt("leda"));
  spdlog::set_pattern("%Y-%m-%dT%H:%M:%S.%eZ %^%l%$ %v", spdlog::pattern_time_type::utc);
  spdlog::set_level(quiet ? spdlog::level::warn : spdlog::level::info);
}

}  // namespace leda::server
