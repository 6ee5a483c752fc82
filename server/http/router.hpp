#pragma once
// Finds the handler of a call in the table of routes.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "server/http/answer.hpp"
#include "server/http/auth.hpp"

namespace leda::server {

struct Site;

struct Route {
  std::string_view method;
  std::string_view path;  ///< "/jobs/{id}/sections/{name}"
  Answer (*handler)(Site& site, const Call& call);
  std::string_view summary;  ///< one line, for /api
  /// Query parameters that the route knows, separated by blanks; any other is refused.
  std::string_view parameters{};
  /// What a success holds, for /api: names of schema/api.json and media types, with blanks between.
  std::string_view answer{};
  Role role = Role::read;
};

struct RouteMatch {
  const Route* route = nullptr;            ///< none: no such path, or no such method on it
  std::vector<std::string> captured;       ///< decoded
  std::vector<std::string> other_methods;  ///< that the path knows
};

/// @param target the path as sent, still percent-encoded, without the query
RouteMatch find_route(std::span<const Route> routes, const std::string& method,
                      const std::string& target);

/// Decodes %xx ('+' is kept). Nothing where an escape is broken.
std::optional<std::string> percent_decode(std::string_view text);

/// Encodes everything but unreserved characters (RFC 3986), for one segment of a path.
std::string percent_encode(std::string_view text);

/// Query parameters of the call that the route does not know.
std::vector<std::string> unknown_parameters(const Route& route, const Call& call);

/// Query parameters that the call gives more than once.
std::vector<std::string> repeated_parameters(const Call& call);

/// What `Allow` says of a path: the methods it knows, HEAD with GET, and OPTIONS.
std::string allowed_methods(const RouteMatch& match);

/// Media types that a success of the route may have.
std::vector<std::string_view> media_types(const Route& route);

}  // namespace leda::server
