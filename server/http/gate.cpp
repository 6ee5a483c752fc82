#include "server/http/gate.hpp"

#include <algorithm>
#include <cctype>

#include "server/http/header_list.hpp"
#include "server/operate/problem.hpp"

namespace leda::server {
namespace {

/// "https://leda.example.org/x" to "leda.example.org".
std::string host_in(const std::string& url) {
  const auto scheme = url.find("://");
  const std::string rest = scheme == std::string::npos ? url : url.substr(scheme + 3);
  return rest.substr(0, rest.find('/'));
}

/// "application/json; charset=utf-16" to "utf-16", in small letters.
std::string charset_of(std::string_view content_type) {
  constexpr std::string_view name = "charset=";
  take_part(content_type, ';');
  while (!content_type.empty()) {
    std::string parameter(take_part(content_type, ';'));
    std::ranges::transform(parameter, parameter.begin(), [](char c) {
      return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    });
    std::erase(parameter, '"');
    if (parameter.starts_with(name)) return parameter.substr(name.size());
  }
  return "";
}

bool is_utf8(const std::string& charset) {
  return charset.empty() || charset == "utf-8" || charset == "utf8" || charset == "us-ascii";
}

}  // namespace

bool is_local_name(std::string host) {
  if (host.starts_with("[")) return host == "[::1]" || host.starts_with("[::1]:");
  host.erase(std::min(host.find(':'), host.size()));
  return host == "127.0.0.1" || host == "localhost";
}

void refuse_at_the_gate(const HeaderOf& header, const Tokens& tokens, const std::string& public_url,
                        const AllowedOrigins& origins) {
  if (header("Content-Type").starts_with("multipart/")) {
    throw Problem(Failure::wrong_media_type, "send the document itself as the body, not a form");
  }
  if (const std::string charset = charset_of(header("Content-Type")); !is_utf8(charset)) {
    throw Problem(Failure::wrong_media_type,
                  "the charset of the Content-Type is '" + charset + "': send texts as UTF-8");
  }
  const std::string own = host_in(public_url);
  const auto is_own = [&](const std::string& host) { return is_local_name(host) || host == own; };
  // A token is in no page's hands, so with tokens any name of this machine will do; without them
  // a foreign name may be a page's that had its own name rebound to this machine.
  const std::string host = header("Host");
  if (!host.empty() && !tokens.required() && !is_own(host)) {
    throw Problem(Failure::foreign_origin, "the Host header names another machine");
  }
  const std::string origin = header("Origin");
  if (!origin.empty() && host_in(origin) != host && !is_own(host_in(origin)) &&
      !origins.allows(origin)) {
    throw Problem(
        Failure::foreign_origin,
        "the Origin header names another machine; serve with --cors-origin to let its pages in");
  }
}

TokenHolder require_role(Role role, const HeaderOf& header, const Tokens& tokens) {
  if (!tokens.required()) return {"-", Role::admin};
  if (role == Role::anyone) return {"-", Role::anyone};
  const auto holder = tokens.holder_of(bearer_token(header("Authorization")));
  if (!holder) {
    throw Problem(Failure::no_token, "send a token: Authorization: Bearer TOKEN");
  }
  if (holder->role < role) {
    throw Problem(Failure::role_too_low, std::string("this needs the role ") + to_string(role) +
                                             ", and the token has " + to_string(holder->role));
  }
  return *holder;
}

}  // namespace leda::server
