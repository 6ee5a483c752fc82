#include "server/http/answer_call.hpp"

#include <string_view>
#include <vector>

#include "server/http/accept.hpp"
#include "server/http/gate.hpp"
#include "server/http/problem_answer.hpp"
#include "server/http/routes.hpp"
#include "server/http/site.hpp"
#include "server/operate/logging.hpp"

namespace leda::server {
namespace {

/// The job that a request is about: of its path, or the one it started.
std::string job_in(const Route& route, const Call& call, const Answer& answer) {
  if (route.path.starts_with("/jobs/{jobID}")) {
    const bool sound = call.captured[0].find_first_not_of(
                           "0123456789abcdefghijklmnopqrstuvwxyzTZ-") == std::string::npos;
    return sound ? call.captured[0] : "-";
  }
  for (const auto& [name, value] : answer.headers) {
    const auto at = value.find("/jobs/");
    if (name == "Location" && at != std::string::npos) return value.substr(at + 6);
  }
  return "-";
}

/// A slash too many is the commonest way to miss a path.
std::string hint_of(const std::string& target) {
  const auto last = target.find_last_not_of('/');
  if (!target.ends_with('/') || last == std::string::npos) return "";
  const std::string without = target.substr(0, last + 1);
  const RouteMatch match = find_route(routes(), "GET", without);
  if (match.route == nullptr && match.other_methods.empty()) return "";
  return ": without the slash at its end there is, " + without;
}

/// Nothing answers this method on this path.
Answer answer_without_route(Site& site, const Call& call, const std::string& target,
                            const RouteMatch& match) {
  const bool preflight = call.method == "OPTIONS" && site.origins.allows(call.header("Origin")) &&
                         !call.header("Access-Control-Request-Method").empty();
  if (!preflight) require_role(Role::read, call.header, site.tokens);
  if (match.other_methods.empty()) {
    throw Problem(Failure::no_such_resource, "there is nothing at " + call.path + hint_of(target));
  }
  const std::string allowed = allowed_methods(match);
  Answer answer;
  if (call.method == "OPTIONS") {
    answer.status = 204;
    if (preflight) answer.headers = AllowedOrigins::preflight(allowed);
  } else {
    answer =
        to_answer(Problem(Failure::wrong_method, call.method + " is not possible on " + call.path),
                  call.path);
  }
  answer.headers.emplace_back("Allow", allowed);
  return answer;
}

void refuse_wrong_parameters(const Route& route, const Call& call) {
  std::vector<Fault> faults;
  for (const auto& name : unknown_parameters(route, call)) {
    faults.push_back({"", "unknown query parameter: " + name});
  }
  for (const auto& name : repeated_parameters(call)) {
    faults.push_back({"", "given more than once: " + name +
                              "; a parameter that takes several values takes them with commas"});
  }
  if (faults.empty()) return;
  throw Problem(Failure::invalid_parameter, "known here: " + std::string(route.parameters), faults);
}

std::string_view without_parameters(std::string_view type) {
  return type.substr(0, type.find(';'));
}

bool is_read(const Call& call) { return call.method == "GET" || call.method == "HEAD"; }

/// Where a route has no f= to choose its form by, the client must want one of those it has. Which
/// of several it is, of a file that is named in the path, its answer alone knows.
void refuse_wrong_accept(const Route& route, const Call& call,
                         const std::vector<std::string_view>& types) {
  const bool chooses = route.parameters == "f" || route.parameters.starts_with("f ");
  if (!is_read(call) || chooses) return;
  const std::string accept = call.header("Accept");
  std::string there_is;
  for (const std::string_view type : types) {
    if (wanted(accept, type).quality > 0) return;
    there_is += (there_is.empty() ? "" : ", ") + std::string(type);
  }
  throw Problem(Failure::not_acceptable, "Accept is '" + accept + "': there is " + there_is);
}

Answer answer_to(Site& site, Call& call, const std::string& target, Told& told) {
  const RouteMatch match = find_route(routes(), call.method, target);
  if (match.route == nullptr) return answer_without_route(site, call, target, match);
  const Route& route = *match.route;
  told.route = route.path;
  call.captured = match.captured;
  told.holder = require_role(route.role, call.header, site.tokens).name;
  refuse_wrong_parameters(route, call);
  refuse_wrong_accept(route, call, media_types(route));
  told.job = job_in(route, call, {});
  Answer answer = route.handler(site, call);
  if (answer.status == 200) refuse_wrong_accept(route, call, {without_parameters(answer.type)});
  if (told.job == "-") told.job = job_in(route, call, answer);
  if (is_read(call) && media_types(route).size() > 1) answer.headers.emplace_back("Vary", "Accept");
  return answer;
}

}  // namespace

Answer answer_call(Site& site, Call& call, const std::string& target, Told& told) {
  try {
    return answer_to(site, call, target, told);
  } catch (const Problem& problem) {
    return to_answer(problem, call.path);
  } catch (const std::exception& error) {
    const std::string reference = random_hex(8);
    log_error(told.job, "request failed reference={} method={} route={} reason={}", reference,
              call.method, told.route, in_quotes(error.what()));
    return to_answer(
        Problem(Failure::internal, "the server's log has the cause under " + reference), call.path);
  }
}

}  // namespace leda::server
