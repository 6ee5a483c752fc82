#pragma once
// The one table from a failure to its HTTP answer (RFC 9457, application/problem+json).

#include <string>

#include "server/http/answer.hpp"
#include "server/operate/problem.hpp"

namespace leda::server {

/// HTTP status of a failure.
int status_of(Failure failure);

/// @param instance the path that was asked for
Answer to_answer(const Problem& problem, const std::string& instance);

}  // namespace leda::server
