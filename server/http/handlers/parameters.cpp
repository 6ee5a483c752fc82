#include "server/http/handlers/parameters.hpp"

#include <fmt/format.h>

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

namespace {

/// "json, csv, svg"
std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

}  // namespace

std::string choice(const Call& call, const std::string& name,
                   const std::vector<std::string>& known) {
  const auto given = call.parameter(name);
  if (!given) return known.front();
  if (std::find(known.begin(), known.end(), *given) != known.end()) return *given;
  throw Problem(Failure::invalid_parameter,
                name + " is '" + *given + "': give one of " + joined(known));
}

std::string format(const Call& call, const std::vector<std::string>& known) {
  if (call.parameter("f")) return choice(call, "f", known);
  const std::string accept = call.header("Accept");
  const auto want = [&](const std::string& name) { return wanted(accept, media_type_of(name)); };
  const auto best = std::max_element(
      known.begin(), known.end(), [&](const auto& a, const auto& b) { return want(a) < want(b); });
  if (want(*best).quality > 0) return *best;
  throw Problem(Failure::not_acceptable, "Accept is '" + accept + "': there is " + joined(known) +
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

// A letter and a number in hexadecimal, so that nobody takes it for a count of items.
std::int64_t page_start(const Call& call) {
  const auto text = call.parameter("cursor");
  if (!text) return 0;
  std::int64_t last = 0;
  const char* end_of_text = text->data() + text->size();
  const bool marked = text->starts_with('c') && text->size() > 1;
  const auto [end, error] = std::from_chars(text->data() + (marked ? 1 : 0), end_of_text, last, 16);
  if (!marked || error != std::errc{} || end != end_of_text || last < 0) {
    throw Problem(Failure::invalid_parameter,
                  "cursor is '" + *text + "': take it from a next link, or leave it out");
  }
  return last;
}

std::string page_after(const Call& call, const std::string& path, std::int64_t last) {
  std::string query;
  const auto add = [&](const std::string& name, const std::string& value) {
    query += (query.empty() ? "?" : "&") + name + "=" + value;
  };
  if (last > 0) add("cursor", fmt::format("c{:x}", last));
  for (const auto& [name, value] : call.query) {
    if (name != "cursor") add(percent_encode(name), percent_encode(value));
  }
  return path + query;
}

}  // namespace leda::server
