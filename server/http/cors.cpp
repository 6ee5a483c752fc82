#include "server/http/cors.hpp"

#include <algorithm>

namespace leda::server {
namespace {

constexpr const char* any = "*";

bool is_origin(const std::string& text) {
  const std::size_t scheme = text.starts_with("https://") ? 8 : text.starts_with("http://") ? 7 : 0;
  return scheme > 0 && text.size() > scheme &&
         text.find_first_of("/?#@*,\"<>\\ \r\n", scheme) == std::string::npos;
}

}  // namespace

std::vector<std::string> AllowedOrigins::faults(bool with_tokens) const {
  std::vector<std::string> found;
  for (const auto& origin : origins_) {
    if (origin == any && !with_tokens) {
      found.push_back(
          "--cors-origin *: without tokens any page in a browser of this machine could do all; "
          "name "
          "the origins, or a file of tokens");
    } else if (origin != any && !is_origin(origin)) {
      found.push_back("--cors-origin " + origin +
                      ": give http(s)://HOST or http(s)://HOST:PORT, without a path");
    }
  }
  return found;
}

bool AllowedOrigins::allows(const std::string& origin) const {
  return std::ranges::any_of(origins_,
                             [&](const auto& known) { return known == any || known == origin; });
}

std::vector<std::pair<std::string, std::string>> AllowedOrigins::headers(
    const std::string& origin) const {
  if (origins_.empty()) return {};
  std::vector<std::pair<std::string, std::string>> headers{{"Vary", "Origin"}};
  if (origin.empty() || !allows(origin)) return headers;
  headers.emplace_back("Access-Control-Allow-Origin", origin);
  headers.emplace_back("Access-Control-Expose-Headers",
                       "Accept-Ranges, Allow, Content-Disposition, Content-Range, ETag, Location, "
                       "Preference-Applied, Retry-After");
  return headers;
}

std::vector<std::pair<std::string, std::string>> AllowedOrigins::preflight(
    const std::string& methods) {
  return {{"Access-Control-Allow-Methods", methods},
          {"Access-Control-Allow-Headers",
           "Authorization, Content-Type, Idempotency-Key, If-None-Match, If-Range, Last-Event-ID, "
           "Prefer, Range"},
          {"Access-Control-Max-Age", "3600"}};
}

}  // namespace leda::server
