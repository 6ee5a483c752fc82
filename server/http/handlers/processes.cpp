#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>
#include <span>

#include "server/documents/execute_options.hpp"
#include "server/http/handlers/handlers.hpp"
#include "server/http/handlers/job_document.hpp"
#include "server/http/handlers/parameters.hpp"
#include "server/http/site.hpp"
#include "server/operate/problem.hpp"
#include "server/operate/version.hpp"

namespace leda::server {
namespace {

using nlohmann::json;

const Process& process_or_problem(const std::string& id) {
  const Process* process = find_process(id);
  if (process == nullptr) throw Problem(Failure::no_such_process, "there is no process " + id);
  return *process;
}

json summary_of(const Process& process, const std::string& url) {
  const std::string own = url + "/processes/" + std::string(process.id);
  return {{"id", process.id},
          {"title", process.title},
          {"description", process.description},
          {"version", version()},
          {"jobControlOptions", {"async-execute", "dismiss"}},
          {"outputTransmission", {"value"}},
          {"links",
           {{{"href", own}, {"rel", "self"}, {"type", "application/json"}},
            {{"href", own + "/execution"},
             {"rel", "http://www.opengis.net/def/rel/ogc/1.0/execute"},
             {"type", "application/json"}}}}};
}

/// Header values arrive percent-decoded, so a key may hold anything until it is checked.
std::string idempotency_key(const Call& call) {
  std::string key = call.header("Idempotency-Key");
  const bool sound = key.size() <= 128 && std::all_of(key.begin(), key.end(), [](unsigned char c) {
                       return std::isalnum(c) != 0 || c == '-' || c == '_' || c == '.' || c == ':';
                     });
  if (!sound) {
    throw Problem(Failure::invalid_request,
                  "Idempotency-Key: at most 128 letters, digits and - _ . :");
  }
  return key;
}

}  // namespace

Answer get_processes(Site& site, const Call& call) {
  format(call, {"json"});
  const auto all = std::span(processes());
  const auto limit = static_cast<std::size_t>(whole_number(call, "limit", 100, 1, 1000));
  const auto first = std::min(static_cast<std::size_t>(page_start(call)), all.size());
  const std::string own = site.url + "/processes";
  json list = json::array();
  for (const Process& process : all.subspan(first, std::min(limit, all.size() - first))) {
    list.push_back(summary_of(process, site.url));
  }
  json links = json::array({{{"href", own}, {"rel", "self"}, {"type", "application/json"}}});
  if (first + list.size() < all.size()) {
    const auto last = static_cast<std::int64_t>(first + list.size());
    links.push_back(
        {{"href", page_after(call, own, last)}, {"rel", "next"}, {"type", "application/json"}});
  }
  return json_answer({{"processes", list}, {"links", links}});
}

Answer get_process(Site& site, const Call& call) {
  format(call, {"json"});
  const Process& process = process_or_problem(call.captured[0]);
  json document = summary_of(process, site.url);
  document.update(process.describe());
  return json_answer(document);
}

Answer post_execution(Site& site, const Call& call) {
  const Process& process = process_or_problem(call.captured[0]);
  const std::string key = idempotency_key(call);
  const std::string request = call.read_body(site.limits.document_bytes);
  if (execute_options_of(request).dry_run)
    return json_answer(dry_run(site.service, process, request));
  const Submitted submitted = submit(site.service, process, request, key);
  Answer answer = json_answer(status_info(submitted.job, site.url), 201);
  answer.headers.emplace_back("Location", site.url + "/jobs/" + submitted.job.id);
  answer.headers.emplace_back("Preference-Applied", "respond-async");
  return answer;
}

}  // namespace leda::server
