#pragma once
// Pages of other origins (CORS, the Fetch standard): which of them a browser may let ask this
// server.

#include <string>
#include <utility>
#include <vector>

namespace leda::server {

class AllowedOrigins {
 public:
  AllowedOrigins() = default;
  /// @param origins "https://maps.example.org" each, or "*" for any
  explicit AllowedOrigins(std::vector<std::string> origins) : origins_(std::move(origins)) {}

  /// What keeps these from being served; empty where nothing does. Any page at all is only let in
  /// where tokens say who it acts for.
  std::vector<std::string> faults(bool with_tokens) const;
  bool allows(const std::string& origin) const;
  bool empty() const { return origins_.empty(); }

  /// What an answer to a page carries. Without an allowed origin only that the answer depends on
  /// it.
  std::vector<std::pair<std::string, std::string>> headers(const std::string& origin) const;
  /// What the answer to a preflight carries beside them.
  /// @param methods "GET, HEAD, ..."
  static std::vector<std::pair<std::string, std::string>> preflight(const std::string& methods);

 private:
  std::vector<std::string> origins_;
};

}  // namespace leda::server
