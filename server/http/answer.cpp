#include "server/http/answer.hpp"

#include <nlohmann/json.hpp>

#include "server/operate/problem.hpp"

namespace leda::server {

std::optional<std::string> Call::parameter(const std::string& name) const {
  const auto [first, last] = query.equal_range(name);
  if (first == last) return std::nullopt;
  return std::prev(last)->second;
}

std::string Call::read_body(std::size_t most_bytes) const {
  std::string text;
  bool too_large = false;
  const bool whole = body([&](const char* data, std::size_t size) {
    too_large = too_large || text.size() + size > most_bytes;
    if (!too_large) text.append(data, size);
    return true;  // the rest is read and dropped, so that the connection stays in step
  });
  if (too_large) {
    throw Problem(Failure::too_large,
                  "the body is larger than " + std::to_string(most_bytes) + " bytes");
  }
  if (!whole) throw Problem(Failure::invalid_request, "the body ended early");
  return text;
}

Answer json_answer(const nlohmann::json& document, int status) {
  Answer answer;
  answer.status = status;
  answer.body = document.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
  return answer;
}

}  // namespace leda::server
