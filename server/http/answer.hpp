#pragma once
// What a handler gets and gives back: HTTP without the HTTP library.

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace leda::server {

/// Hands out the body piece by piece; the receiver returns false to stop.
/// @return false where the body could not be read whole
using BodyReader = std::function<bool(const std::function<bool(const char*, std::size_t)>&)>;

struct Call {
  std::string method;
  std::string path;                                       ///< decoded, for messages
  std::vector<std::string> captured;                      ///< of the route's {…}, decoded
  std::multimap<std::string, std::string> query;          ///< decoded
  std::function<std::string(const std::string&)> header;  ///< empty where absent
  BodyReader body;

  /// The value of a query parameter; the last one where it is repeated.
  std::optional<std::string> parameter(const std::string& name) const;
  /// The whole body. @throws Problem too_large beyond `most_bytes`
  std::string read_body(std::size_t most_bytes) const;
};

struct Answer {
  int status = 200;
  std::string type = "application/json";
  std::string body;
  std::vector<std::pair<std::string, std::string>> headers;
  std::filesystem::path file;  ///< sent instead of `body` where not empty
  /// Server-Sent Events instead of `body`: asked again and again for the next piece, which may be
  /// empty; nothing ends the stream.
  std::function<std::optional<std::string>()> stream;
};

Answer json_answer(const nlohmann::json& document, int status = 200);

}  // namespace leda::server
