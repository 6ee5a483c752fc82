#pragma once
// Lines to standard error that programs can read: time=… level=… job=… and then an event with its
// values, key=value. Every line names the job it is about, or "-".

#include <spdlog/spdlog.h>

#include <string_view>
#include <utility>

namespace leda::server {

/// @param quiet warnings and errors only
void set_up_logging(bool quiet);

/// Text from outside (names, reasons, what a worker said), safe in a line: quoted, without line
/// ends.
std::string in_quotes(std::string_view text);

template <class... Values>
void log_info(std::string_view job, fmt::format_string<Values...> text, Values&&... values) {
  spdlog::info("job={} {}", job, fmt::format(text, std::forward<Values>(values)...));
}

template <class... Values>
void log_warning(std::string_view job, fmt::format_string<Values...> text, Values&&... values) {
  spdlog::warn("job={} {}", job, fmt::format(text, std::forward<Values>(values)...));
}

template <class... Values>
void log_error(std::string_view job, fmt::format_string<Values...> text, Values&&... values) {
  spdlog::error("job={} {}", job, fmt::format(text, std::forward<Values>(values)...));
}

}  // namespace leda::server
