#pragma once
// The one table from a failure to its HTTP answer (RFC 9457, application/problem+json).

#include <stdexcept>
#include <string>
#include <vector>

#include "server/http/answer.hpp"
#include "solver/section/validate.hpp"

namespace leda::server {

enum class Failure {
  invalid_request,
  invalid_parameter,
  no_such_process,
  no_such_job,
  no_such_result,
  result_not_ready,
  no_such_resource,
  wrong_method,
  not_acceptable,
  length_required,
  too_large,
  wrong_media_type,
  no_such_range,
  no_token,
  role_too_low,
  foreign_origin,
  name_taken,
  wrong_state,
  key_reused,
  queue_full,
  too_busy,
  job_failed,
  internal
};

/// Thrown by handlers; ends the request and nothing else.
class Problem : public std::runtime_error {
 public:
  Problem(Failure kind, const std::string& detail, std::vector<Fault> faults_found = {})
      : std::runtime_error(detail), failure(kind), faults(std::move(faults_found)) {}
  Failure failure;
  std::vector<Fault> faults;  ///< each with the JSON pointer to what is wrong
};

/// HTTP status of a failure.
int status_of(Failure failure);

/// @param instance the path that was asked for
Answer to_answer(const Problem& problem, const std::string& instance);

}  // namespace leda::server
