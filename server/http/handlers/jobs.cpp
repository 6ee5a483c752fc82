#include <algorithm>
#include <nlohmann/json.hpp>

#include "server/http/handlers/datetime.hpp"
#include "server/http/handlers/handlers.hpp"
#include "server/http/handlers/job_document.hpp"
#include "server/http/handlers/parameters.hpp"
#include "server/http/site.hpp"
#include "server/operate/problem.hpp"

namespace leda::server {
namespace {

using nlohmann::json;

db::JobFilter filter_of(const Call& call) {
  db::JobFilter filter;
  filter.processes = list(call, "processID");
  for (const auto& name : list(call, "status")) {
    const auto state = db::job_state_from(name);
    if (!state) {
      throw Problem(
          Failure::invalid_parameter,
          "status is '" + name + "': give accepted, running, successful, failed or dismissed");
    }
    filter.states.push_back(*state);
  }
  const Interval created = interval(call);
  filter.created_from = created.from;
  filter.created_to = created.to;
  filter.least_s = seconds(call, "minDuration");
  filter.most_s = seconds(call, "maxDuration");
  filter.limit = whole_number(call, "limit", 100, 1, 1000);
  filter.before = page_start(call);
  return filter;
}

}  // namespace

Answer get_jobs(Site& site, const Call& call) {
  format(call, {"json"});
  const db::JobFilter filter = filter_of(call);
  const auto types = list(call, "type");
  const bool none =
      !types.empty() && std::find(types.begin(), types.end(), "process") == types.end();
  std::vector<db::JobStatus> page;
  if (!none) {
    db::JobFilter one_more = filter;
    ++one_more.limit;  // tells whether there is a next page
    page = site.service.store.jobs(one_more);
  }
  const std::string own = site.url + "/jobs";
  json links = json::array({{{"href", own}, {"rel", "self"}, {"type", "application/json"}}});
  if (page.size() > static_cast<std::size_t>(filter.limit)) {
    page.pop_back();
    links.push_back({{"href", page_after(call, own, page.back().sequence)},
                     {"rel", "next"},
                     {"type", "application/json"}});
  }
  json jobs = json::array();
  for (const auto& job : page) jobs.push_back(status_info(job, site.url));
  const int total = none ? 0 : site.service.store.count_jobs(filter);
  return json_answer({{"jobs", jobs}, {"links", links}, {"numberMatched", total}});
}

Answer get_job(Site& site, const Call& call) {
  format(call, {"json"});
  return json_answer(
      status_info(job_status_or_problem(site.service.store, call.captured[0]), site.url));
}

Answer delete_job(Site& site, const Call& call) {
  const std::string& id = call.captured[0];
  job_status_or_problem(site.service.store, id);
  site.service.dispatcher.dismiss(id);
  return json_answer(status_info(job_status_or_problem(site.service.store, id), site.url));
}

Answer post_retry(Site& site, const Call& call) {
  return json_answer(status_info(retry(site.service, call.captured[0]), site.url));
}

}  // namespace leda::server
