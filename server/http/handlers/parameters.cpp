#include "server/http/handlers/parameters.hpp"

#include <algorithm>
#include <charconv>
#include <string_view>

#include "profiles/export_layers.hpp"
#include "server/http/accept.hpp"
#include "server/http/header_list.hpp"
#include "server/http/router.hpp"
#include "server/operate/problem.hpp"

namespace leda::server {
namespace {

/// Of a value of f=.
std::string media_type_of(const std::string& format) {
  if (format == "html") return "text/html";
  if (format == "csv") return "text/csv";
  if (format == "svg") return "image/svg+xml";
  const auto layers = profiles::export_format_from(format);
  return layers ? profiles::media_type(*layers) : "application/json";
}

}  // namespace

int whole_number(const Call& call, const std::string& name, int absent, int least, int most) {
  const auto text = call.parameter(name);
  if (!text) return absent;
  int value = 0;
  const char* last = text->data() + text->size();
  const auto [end, error] = std::from_chars(text->data(), last, value);
  if (error != std::errc{} || end != last || value < least) {
    throw Problem(Failure::invalid_parameter,
                  name + " is '" + *text + "': give a whole number from " + std::to_string(least) +
                      " to " + std::to_string(most));
  }
  return std::min(value, most);
}

std::vector<std::string> list(const Call& call, const std::string& name) {
  std::vector<std::string> parts;
  const auto text = call.parameter(name);
  if (!text || text->empty()) return parts;
  std::size_t from = 0;
  for (;;) {
    const std::size_t comma = text->find(',', from);
    parts.push_back(text->substr(from, comma - from));
    if (comma == std::string::npos) return parts;
    from = comma + 1;
  }
}

std::string format(const Call& call, const std::vector<std::string>& known) {
  const auto given = call.parameter("f");
  if (given && std::find(known.begin(), known.end(), *given) != known.end()) return *given;
  std::string choice;
  for (const auto& name : known) choice += (choice.empty() ? "" : ", ") + name;
  if (given) {
    throw Problem(Failure::invalid_parameter, "f is '" + *given + "': give one of " + choice);
  }
  const std::string accept = call.header("Accept");
  const auto want = [&](const std::string& name) { return wanted(accept, media_type_of(name)); };
  const auto best = std::max_element(
      known.begin(), known.end(), [&](const auto& a, const auto& b) { return want(a) < want(b); });
  if (want(*best).quality > 0) return *best;
  throw Problem(Failure::not_acceptable, "Accept is '" + accept + "': there is " + choice +
                                             ", which f= chooses whatever Accept says");
}

std::optional<double> seconds(const Call& call, const std::string& name) {
  const auto text = call.parameter(name);
  if (!text) return std::nullopt;
  double value = -1;
  const char* last = text->data() + text->size();
  const auto [end, error] = std::from_chars(text->data(), last, value);
  if (error != std::errc{} || end != last || !(value >= 0 && value < 1e12)) {
    throw Problem(Failure::invalid_parameter,
                  name + " is '" + *text + "': give a number of seconds");
  }
  return value;
}

bool has_already(const Call& call, const std::string& tag) {
  const std::string given = call.header("If-None-Match");
  std::string_view rest = given;
  while (!rest.empty()) {
    std::string_view one = take_part(rest, ',');
    if (one.starts_with("W/")) one.remove_prefix(2);
    if (one == tag || one == "*") return true;
  }
  return false;
}

Answer not_modified(const std::string& tag) {
  Answer answer;
  answer.status = 304;
  answer.headers.emplace_back("ETag", tag);
  return answer;
}

Interval interval(const Call& call) {
  const auto given = call.parameter("datetime");
  if (!given) return {};
  const auto slash = given->find('/');
  const auto end_of = [&](const std::string& text, const char* time_of_a_day) {
    if (slash != std::string::npos && (text.empty() || text == "..")) return std::string();
    if (!is_datetime(text)) {
      throw Problem(
          Failure::invalid_parameter,
          "datetime is '" + *given +
              "': give 2026-01-31, 2026-01-31T12:00:00Z or FROM/TO, with .. for an open end");
    }
    const bool is_day = text.find('T') == std::string::npos;
    return is_day ? text + time_of_a_day : text;
  };
  const std::string from = given->substr(0, slash);
  const std::string to = slash == std::string::npos ? from : given->substr(slash + 1);
  return {end_of(from, "T00:00:00Z"), end_of(to, "T23:59:59.999Z")};
}

bool is_datetime(const std::string& text) {
  const auto number = [&](std::size_t at, std::size_t digits) {
    int value = -1;
    if (at + digits > text.size()) return -1;
    const char* first = text.data() + at;
    const auto [end, error] = std::from_chars(first, first + digits, value);
    return error == std::errc{} && end == first + digits ? value : -1;
  };
  const auto within = [](int value, int least, int most) {
    return value >= least && value <= most;
  };
  const bool date = text.size() >= 10 && text[4] == '-' && text[7] == '-' && number(0, 4) >= 0 &&
                    within(number(5, 2), 1, 12) && within(number(8, 2), 1, 31);
  if (!date || text.size() == 10) return date;
  const bool time = text.size() >= 20 && text.size() <= 35 && text[10] == 'T' && text[13] == ':' &&
                    text[16] == ':' && within(number(11, 2), 0, 23) &&
                    within(number(14, 2), 0, 59) && within(number(17, 2), 0, 60);
  if (!time) return false;
  const auto zone = text.find_first_not_of("0123456789.", 19);
  if (zone == std::string::npos) return false;
  if (text[zone] == 'Z') return zone + 1 == text.size();
  const bool offset = text[zone] == '+' || text[zone] == '-';
  return offset && zone + 6 == text.size() && text[zone + 3] == ':' &&
         within(number(zone + 1, 2), 0, 23) && within(number(zone + 4, 2), 0, 59);
}

std::string with_offset(const Call& call, const std::string& path, int offset) {
  std::string url = path + "?offset=" + std::to_string(offset);
  for (const auto& [name, value] : call.query) {
    if (name != "offset") url += "&" + percent_encode(name) + "=" + percent_encode(value);
  }
  return url;
}

}  // namespace leda::server
