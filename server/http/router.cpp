#include "server/http/router.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>

namespace leda::server {
namespace {

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

/// The captured segments where the path fits the route's.
std::optional<std::vector<std::string>> match(std::string_view pattern, std::string_view target) {
  const auto wanted = split(pattern, '/');
  const auto given = split(target, '/');
  if (wanted.size() != given.size()) return std::nullopt;
  std::vector<std::string> captured;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const auto segment = percent_decode(given[i]);
    if (!segment) return std::nullopt;
    if (wanted[i].starts_with('{')) {
      if (segment->empty()) return std::nullopt;
      captured.push_back(*segment);
    } else if (*segment != wanted[i]) {
      return std::nullopt;
    }
  }
  return captured;
}

}  // namespace

RouteMatch find_route(std::span<const Route> routes, const std::string& method,
                      const std::string& target) {
  RouteMatch found;
  const std::string asked = method == "HEAD" ? "GET" : method;
  for (const Route& route : routes) {
    auto captured = match(route.path, target);
    if (!captured) continue;
    if (route.method == asked) {
      found.route = &route;
      found.captured = std::move(*captured);
      return found;
    }
    found.other_methods.emplace_back(route.method);
  }
  return found;
}

std::optional<std::string> percent_decode(std::string_view text) {
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      decoded += text[i];
      continue;
    }
    if (i + 2 >= text.size()) return std::nullopt;
    unsigned value = 0;
    const char* first = text.data() + i + 1;
    const auto [end, error] = std::from_chars(first, first + 2, value, 16);
    if (error != std::errc{} || end != first + 2) return std::nullopt;
    decoded += static_cast<char>(value);
    i += 2;
  }
  return decoded;
}

std::string percent_encode(std::string_view text) {
  constexpr std::string_view hex = "0123456789ABCDEF";
  std::string encoded;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) != 0 || c == '-' || c == '.' || c == '_' || c == '~') {
      encoded += c;
    } else {
      encoded += '%';
      encoded += hex[byte >> 4];
      encoded += hex[byte & 15];
    }
  }
  return encoded;
}

std::vector<std::string> unknown_parameters(const Route& route, const Call& call) {
  const auto known = split(route.parameters, ' ');
  std::vector<std::string> unknown;
  for (const auto& [name, value] : call.query) {
    if (std::find(known.begin(), known.end(), name) == known.end()) unknown.push_back(name);
  }
  return unknown;
}

std::vector<std::string> repeated_parameters(const Call& call) {
  std::vector<std::string> repeated;
  for (auto at = call.query.begin(); at != call.query.end();) {
    const auto after = call.query.upper_bound(at->first);
    if (std::distance(at, after) > 1) repeated.push_back(at->first);
    at = after;
  }
  return repeated;
}

std::string allowed_methods(const RouteMatch& match) {
  std::string allowed;
  for (const auto& method : match.other_methods) {
    allowed += method + (method == "GET" ? ", HEAD, " : ", ");
  }
  return allowed + "OPTIONS";
}

std::vector<std::string_view> media_types(const Route& route) {
  std::vector<std::string_view> types;
  if (route.answer.empty()) return types;
  for (const auto name : split(route.answer, ' ')) {
    types.push_back(name.find('/') == std::string_view::npos ? "application/json"
                                                             : name.substr(0, name.find(';')));
  }
  return types;
}

}  // namespace leda::server
