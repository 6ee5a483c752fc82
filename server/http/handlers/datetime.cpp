#include "server/http/handlers/datetime.hpp"

#include <date/date.h>

#include <sstream>

#include "server/operate/problem.hpp"

namespace leda::server {
namespace {

/// What it reads must be all there is, written with all its digits.
template <class Value, class... More>
bool reads(const std::string& text, const char* form, Value& value, More*... more) {
  std::istringstream in(text);
  date::from_stream(in, form, value, static_cast<std::string*>(nullptr), more...);
  return !in.fail() && in.peek() == std::istringstream::traits_type::eof();
}

/// The end of an interval. @param time_of_a_day "T00:00:00Z"
std::optional<std::string> end_from(const std::string& text, const char* time_of_a_day) {
  if (is_day(text)) return text + time_of_a_day;
  return utc_from(text);
}

/// Either end may have a fraction of a second: without the Z text is in the order of time.
bool is_reversed(const Interval& interval) {
  if (interval.from.empty() || interval.to.empty()) return false;
  const auto without_z = [](const std::string& time) { return time.substr(0, time.size() - 1); };
  return without_z(interval.from) > without_z(interval.to);
}

}  // namespace

bool is_day(const std::string& text) {
  date::year_month_day day;
  return reads(text, "%F", day) && day.ok() && date::format("%F", day) == text;
}

std::optional<std::string> utc_from(const std::string& time) {
  constexpr std::size_t to_the_second = 19, zone_length = 6;  // "+01:00"
  const std::string zoned = time.ends_with('Z') ? time.substr(0, time.size() - 1) + "+00:00" : time;
  if (zoned.size() < to_the_second + zone_length || zoned[zoned.size() - 3] != ':') return {};
  date::sys_time<std::chrono::nanoseconds> utc;
  std::chrono::minutes offset{0};
  if (!reads(zoned, "%FT%T%Ez", utc, &offset)) return {};
  const auto as_written = date::floor<std::chrono::seconds>(utc + offset);
  if (date::format("%FT%T", as_written) != zoned.substr(0, to_the_second)) return {};
  return date::format("%FT%TZ", date::floor<std::chrono::milliseconds>(utc));
}

Interval interval(const Call& call) {
  const auto given = call.parameter("datetime");
  if (!given) return {};
  const auto slash = given->find('/');
  const auto end_of = [&](const std::string& text, const char* time_of_a_day) {
    if (slash != std::string::npos && (text.empty() || text == "..")) return std::string();
    const auto end = end_from(text, time_of_a_day);
    if (end) return *end;
    throw Problem(
        Failure::invalid_parameter,
        "datetime is '" + *given +
            "': give 2026-01-31, 2026-01-31T12:00:00Z or FROM/TO, with .. for an open end");
  };
  const std::string from = given->substr(0, slash);
  const std::string to = slash == std::string::npos ? from : given->substr(slash + 1);
  Interval interval{end_of(from, "T00:00:00Z"), end_of(to, "T23:59:59.999Z")};
  if (is_reversed(interval)) {
    throw Problem(Failure::invalid_parameter,
                  "datetime is '" + *given + "', which ends before it begins: give FROM/TO");
  }
  return interval;
}

}  // namespace leda::server
