#pragma once
// Why a request cannot be done, for whoever asked: over HTTP or on the command line.

#include <stdexcept>
#include <string>
#include <vector>

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

/// Whether the server or the job failed, and not the request.
constexpr bool is_ours(Failure failure) {
  return failure == Failure::too_busy || failure == Failure::job_failed ||
         failure == Failure::internal;
}

/// Ends the request and nothing else.
class Problem : public std::runtime_error {
 public:
  Problem(Failure kind, const std::string& detail, std::vector<Fault> faults_found = {})
      : std::runtime_error(detail), failure(kind), faults(std::move(faults_found)) {}
  Failure failure;
  std::vector<Fault> faults;  ///< each with the JSON pointer to what is wrong
};

}  // namespace leda::server
