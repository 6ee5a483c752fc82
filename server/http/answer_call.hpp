#pragma once
// From a call to its answer: the route, who may, what is asked of it, and its handler.

#include <string>

#include "server/http/answer.hpp"

namespace leda::server {

struct Site;

/// What the log and the metrics tell of a request.
struct Told {
  std::string route = "none";
  std::string job = "-";
  std::string holder = "-";
};

/// Every failure becomes an answer; the log has what is not the client's fault. `call.captured` is
/// filled in. Safe from several threads.
/// @param target the path as sent, still percent-encoded, without the query
Answer answer_call(Site& site, Call& call, const std::string& target, Told& told);

}  // namespace leda::server
