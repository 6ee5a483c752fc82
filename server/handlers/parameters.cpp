#include "server/handlers/parameters.hpp"

#include <algorithm>
#include <charconv>

#include "server/problem.hpp"
#include "server/router.hpp"

namespace leda::server {

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

bool wants_html(const Call& call) {
  if (const auto f = call.parameter("f")) return *f == "html";
  const std::string accept = call.header("Accept");
  const auto html = accept.find("text/html");
  return html != std::string::npos && html <= accept.find("application/json");
}

std::string format(const Call& call, const std::vector<std::string>& known) {
  const auto given = call.parameter("f");
  if (!given) return known.front();
  if (std::find(known.begin(), known.end(), *given) != known.end()) return *given;
  std::string choice;
  for (const auto& name : known) choice += (choice.empty() ? "" : ", ") + name;
  throw Problem(Failure::invalid_parameter, "f is '" + *given + "': give one of " + choice);
}

std::string with_offset(const Call& call, const std::string& path, int offset) {
  std::string url = path + "?offset=" + std::to_string(offset);
  for (const auto& [name, value] : call.query) {
    if (name != "offset") url += "&" + percent_encode(name) + "=" + percent_encode(value);
  }
  return url;
}

}  // namespace leda::server
