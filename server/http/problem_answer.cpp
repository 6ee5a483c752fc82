#include "server/http/problem_answer.hpp"

#include <array>
#include <nlohmann/json.hpp>

namespace leda::server {
namespace {

struct Row {
  Failure failure;
  int status;
  const char* type;
  const char* title;
};

#define OGC "http://www.opengis.net/def/exceptions/ogcapi-processes-1/1.0/"

constexpr std::array rows{
    Row{Failure::invalid_request, 400, "urn:leda:problem:invalid-request", "Invalid request"},
    Row{Failure::invalid_parameter, 400, "urn:leda:problem:invalid-parameter",
        "Invalid query parameter"},
    Row{Failure::no_such_process, 404, OGC "no-such-process", "No such process"},
    Row{Failure::no_such_job, 404, OGC "no-such-job", "No such job"},
    Row{Failure::no_such_result, 404, "urn:leda:problem:no-such-result", "No such result"},
    Row{Failure::result_not_ready, 404, OGC "result-not-ready", "Result not ready"},
    Row{Failure::no_such_resource, 404, "urn:leda:problem:not-found", "Not found"},
    Row{Failure::wrong_method, 405, "urn:leda:problem:wrong-method", "Method not allowed"},
    Row{Failure::not_acceptable, 406, "urn:leda:problem:not-acceptable", "Not acceptable"},
    Row{Failure::length_required, 411, "urn:leda:problem:length-required", "Length required"},
    Row{Failure::too_large, 413, "urn:leda:problem:too-large", "Content too large"},
    Row{Failure::wrong_media_type, 415, "urn:leda:problem:wrong-media-type",
        "Unsupported media type"},
    Row{Failure::no_such_range, 416, "urn:leda:problem:no-such-range", "Range not satisfiable"},
    Row{Failure::no_token, 401, "urn:leda:problem:no-token", "No valid token"},
    Row{Failure::role_too_low, 403, "urn:leda:problem:role-too-low", "Role too low"},
    Row{Failure::foreign_origin, 403, "urn:leda:problem:foreign-origin", "Foreign origin"},
    Row{Failure::name_taken, 409, "urn:leda:problem:name-taken", "Name taken"},
    Row{Failure::wrong_state, 409, "urn:leda:problem:wrong-state", "Not possible in this state"},
    Row{Failure::key_reused, 422, "urn:leda:problem:key-reused", "Idempotency key reused"},
    Row{Failure::queue_full, 429, "urn:leda:problem:queue-full", "Queue full"},
    Row{Failure::too_busy, 503, "urn:leda:problem:too-busy", "Too busy"},
    Row{Failure::job_failed, 500, "urn:leda:problem:job-failed", "Job failed"},
    Row{Failure::internal, 500, "urn:leda:problem:internal", "Internal error"},
};

#undef OGC

const Row& row_of(Failure failure) {
  for (const Row& row : rows) {
    if (row.failure == failure) return row;
  }
  return rows.back();
}

}  // namespace

int status_of(Failure failure) { return row_of(failure).status; }

Answer to_answer(const Problem& problem, const std::string& instance) {
  const Row& row = row_of(problem.failure);
  nlohmann::json document = {{"type", row.type},
                             {"title", row.title},
                             {"status", row.status},
                             {"detail", problem.what()},
                             {"instance", instance}};
  for (const Fault& fault : problem.faults) {
    document["errors"].push_back({{"pointer", fault.pointer}, {"detail", fault.message}});
  }
  Answer answer = json_answer(document, row.status);
  answer.type = "application/problem+json";
  if (problem.failure == Failure::too_busy) answer.headers.emplace_back("Retry-After", "5");
  if (problem.failure == Failure::queue_full) answer.headers.emplace_back("Retry-After", "30");
  if (problem.failure == Failure::no_token) {
    answer.headers.emplace_back("WWW-Authenticate", "Bearer realm=\"leda\"");
  }
  return answer;
}

}  // namespace leda::server
