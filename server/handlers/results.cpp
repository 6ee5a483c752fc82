#include <nlohmann/json.hpp>

#include "profiles/export_layers.hpp"
#include "server/compare_sections.hpp"
#include "server/documents/compare_document.hpp"
#include "server/features.hpp"
#include "server/handlers/handlers.hpp"
#include "server/handlers/parameters.hpp"
#include "server/handlers/section_document.hpp"
#include "server/problem.hpp"
#include "server/region_layers.hpp"
#include "server/router.hpp"
#include "server/service.hpp"

namespace leda::server {
namespace {

using nlohmann::json;

/// @throws Problem where the job has no results, or none yet
db::JobRecord finished_job(const Service& service, const std::string& id) {
  auto job = job_or_problem(service.store, id);
  switch (job.state) {
    case db::JobState::accepted:
    case db::JobState::running:
      throw Problem(Failure::result_not_ready,
                    "job " + id + " is " + db::to_string(job.state) + ": " + job.message);
    case db::JobState::failed:
      throw Problem(Failure::job_failed, "job " + id + " failed: " + job.message);
    case db::JobState::dismissed:
      throw Problem(Failure::no_such_result, "job " + id + " was dismissed");
    case db::JobState::successful:
      break;
  }
  return job;
}

/// Results of a finished job never change; a retry changes `updated`.
std::string tag_of(const db::JobRecord& job) { return "\"" + job.id + "-" + job.updated + "\""; }

const char* media_type_of(const std::string& format) {
  if (format == "svg") return "image/svg+xml";
  return format == "csv" ? "text/csv" : "application/json";
}

/// A whole job in one page: a layout has a limit of its own.
db::PageFilter all_of(const db::JobRecord& job) {
  db::PageFilter filter;
  filter.job = job.id;
  filter.limit = 1'000'000;
  return filter;
}

json rows_of(const Service& service, const db::JobRecord& job) {
  json rows = json::array();
  const std::string own = service.url + "/jobs/" + job.id + "/sections/";
  for (const auto& section : service.store.sections(job.id)) {
    json row = section_row(section);
    row["links"] = json::array({{{"href", own + percent_encode(section.name)},
                                 {"rel", "item"},
                                 {"type", "application/json"}}});
    rows.push_back(row);
  }
  return rows;
}

}  // namespace

Answer get_results(Service& service, const Call& call) {
  const auto job = finished_job(service, call.captured[0]);
  const Process* process = find_process(job.process);
  const bool own_form = process != nullptr && process->results != nullptr;
  const std::string wanted =
      own_form ? format(call, {"json", "csv", "svg"}) : format(call, {"json"});
  if (call.header("If-None-Match") == tag_of(job)) {
    Answer unchanged;
    unchanged.status = 304;
    unchanged.headers.emplace_back("ETag", tag_of(job));
    return unchanged;
  }
  if (own_form) {
    Answer answer;
    answer.type = media_type_of(wanted);
    answer.body = process->results(job, service.store.sections(job.id), wanted);
    answer.headers.emplace_back("ETag", tag_of(job));
    return answer;
  }
  json results = {{"sections", rows_of(service, job)}};
  if (epsg_of(service.store, job) != 0) {
    for (const Collection zones : {Collection::release_zones, Collection::runout_zones}) {
      results[to_string(zones)] =
          feature_collection(feature_page(service.store, zones, all_of(job)));
    }
  }
  Answer answer = json_answer(results);
  answer.headers.emplace_back("ETag", tag_of(job));
  return answer;
}

Answer get_sections(Service& service, const Call& call) {
  format(call, {"json"});
  const auto job = job_or_problem(service.store, call.captured[0]);
  return json_answer({{"job", job.id},
                      {"status", db::to_string(job.state)},
                      {"message", job.message},
                      {"sections", rows_of(service, job)}});
}

Answer get_section(Service& service, const Call& call) {
  format(call, {"json"});
  const auto found = sections_or_problem(service.store, call.captured[0], {call.captured[1]});
  return json_answer(section_detail(found.front(), service.data));
}

Answer get_compare(Service& service, const Call& call) {
  const bool drawing = format(call, {"json", "svg"}) == "svg";
  const auto names = list(call, "sections");
  if (names.size() < 2 || names.size() > 20) {
    throw Problem(Failure::invalid_parameter,
                  "sections: give 2 to 20 names, for example sections=AA',BB'");
  }
  const auto compared = as_compared(sections_or_problem(service.store, call.captured[0], names));
  if (!drawing) return json_answer(compare_json(compared));
  Answer answer;
  answer.type = "image/svg+xml";
  answer.body = compare_svg(compared);
  return answer;
}

Answer get_export(Service& service, const Call& call) {
  const auto wanted = format(call, {"gpkg", "geojson", "shp", "fgb"});
  const auto job = finished_job(service, call.captured[0]);
  const auto kind = profiles::export_format_from(wanted).value();
  const std::string name = job.id + profiles::file_ending(kind);
  Answer answer;
  answer.file = service.data.exports() / name;
  answer.type = profiles::media_type(kind);
  answer.headers.emplace_back("Content-Disposition", "attachment; filename=\"" + name + "\"");
  profiles::export_layers(region_layers(service.store, job), kind, answer.file);
  return answer;
}

}  // namespace leda::server
