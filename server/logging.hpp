#pragma once

namespace leda::server {

/// Structured lines to standard error: time, level, message with job= section= run=.
/// @param quiet warnings and errors only
void set_up_logging(bool quiet);

}  // namespace leda::server
