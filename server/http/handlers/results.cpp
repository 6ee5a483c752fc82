#include <nlohmann/json.hpp>

#include "profiles/export_layers.hpp"
#include "server/documents/compare_document.hpp"
#include "server/documents/execute_options.hpp"
#include "server/drawings/ensemble_drawing.hpp"
#include "server/http/handlers/handlers.hpp"
#include "server/http/handlers/parameters.hpp"
#include "server/http/handlers/section_document.hpp"
#include "server/http/router.hpp"
#include "server/http/site.hpp"
#include "server/layers/compare_sections.hpp"
#include "server/layers/exports.hpp"
#include "server/layers/features.hpp"
#include "server/layers/job_ensemble.hpp"
#include "server/layers/region_layers.hpp"
#include "server/operate/problem.hpp"

namespace leda::server {
namespace {

using nlohmann::json;

/// @throws Problem where the job has no results, or none yet
db::JobStatus finished_job(const Site& site, const std::string& id) {
  auto job = job_status_or_problem(site.service.store, id);
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
std::string tag_of(const db::JobStatus& job, const std::string& format) {
  return "\"" + job.id + "-" + job.updated + "-" + format + "\"";
}

const char* media_type_of(const std::string& format) {
  if (format == "svg") return "image/svg+xml";
  return format == "csv" ? "text/csv" : "application/json";
}

/// A whole job in one page: a layout has a limit of its own.
db::PageFilter all_of(const db::JobStatus& job) {
  db::PageFilter filter;
  filter.job = job.id;
  filter.limit = 1'000'000;
  return filter;
}

json rows_of(Site& site, const db::JobStatus& job, const std::vector<db::SectionRecord>& sections) {
  json rows = json::array();
  const std::string own = site.url + "/jobs/" + job.id + "/sections/";
  const auto raster = site.service.store.raster(job.raster);
  for (const auto& section : sections) {
    json row = section_row(section);
    row["dem_sha256"] = raster ? json(raster->sha256) : json();
    row["links"] = json::array({{{"href", own + percent_encode(section.name)},
                                 {"rel", "item"},
                                 {"type", "application/json"}}});
    rows.push_back(std::move(row));
  }
  return rows;
}

Answer file_answer(Site& site, const Call& call, const db::JobStatus& job,
                   const std::string& wanted) {
  const auto kind = profiles::export_format_from(wanted).value();
  const std::string tag = tag_of(job, wanted);
  if (has_already(call, tag)) return not_modified(tag);
  Answer answer;
  answer.file = export_of(site.service.data, site.service.store, job, kind);
  answer.type = profiles::media_type(kind);
  answer.headers.emplace_back("ETag", tag);
  answer.headers.emplace_back("Content-Disposition", "attachment; filename=\"" + job.id +
                                                         profiles::file_ending(kind) + "\"");
  return answer;
}

/// The outputs by name, or where the request wanted one alone, that one.
json wanted_of(json outputs, const ExecuteOptions& options) {
  if (options.outputs.empty()) return outputs;
  if (options.raw) return outputs[options.outputs.front()];
  json wanted = json::object();
  for (const auto& name : options.outputs) wanted[name] = std::move(outputs[name]);
  return wanted;
}

json outputs_of(Site& site, const db::JobStatus& job) {
  const db::Turns::Turn turn(site.pages);
  json outputs = {{"sections", rows_of(site, job, site.service.store.section_page(all_of(job)))}};
  if (epsg_of(site.service.store, job) != 0) {
    for (const Collection zones : all_collections) {
      if (zones == Collection::sections) continue;
      json features = json::array();
      for_each_feature(site.service.store, zones, all_of(job),
                       [&](json&& feature) { features.push_back(std::move(feature)); });
      outputs[to_string(zones)] = {{"type", "FeatureCollection"}, {"features", features}};
    }
  }
  return outputs;
}

}  // namespace

Answer get_results(Site& site, const Call& call) {
  const auto job = finished_job(site, call.captured[0]);
  const Process* process = find_process(job.process);
  const bool own_form = process != nullptr && process->results != nullptr;
  const std::string wanted = own_form ? format(call, {"json", "csv", "svg"})
                                      : format(call, {"json", "geojson", "gpkg", "shp", "fgb"});
  if (!own_form && wanted != "json") return file_answer(site, call, job, wanted);
  const std::string tag = tag_of(job, wanted);
  if (has_already(call, tag)) return not_modified(tag);
  const auto asked = job_or_problem(site.service.store, job.id);
  Answer answer;
  if (own_form) {
    answer.body = process->results(asked, site.service.store.sections(job.id), wanted);
  }
  if (wanted == "json") {
    const ExecuteOptions options = execute_options_of(asked.request);
    json outputs = own_form ? json::parse(answer.body) : outputs_of(site, job);
    answer = json_answer(wanted_of(std::move(outputs), options));
  }
  answer.type = media_type_of(wanted);
  answer.headers.emplace_back("ETag", tag);
  return answer;
}

Answer get_sections(Site& site, const Call& call) {
  format(call, {"json"});
  const auto job = job_status_or_problem(site.service.store, call.captured[0]);
  db::PageFilter page;
  page.job = job.id;
  const int limit = whole_number(call, "limit", 10'000, 1, 10'000);
  page.limit = limit + 1;  // tells whether there is a next page
  page.after = page_start(call);
  const int total = site.service.store.count_sections(page);
  const db::Turns::Turn turn(site.pages);
  auto sections = site.service.store.section_page(page);
  const bool more = sections.size() > static_cast<std::size_t>(limit);
  if (more) sections.pop_back();
  json rows = rows_of(site, job, sections);
  const std::string own = site.url + "/jobs/" + job.id + "/sections";
  json links = json::array({{{"href", page_after(call, own, page.after)},
                             {"rel", "self"},
                             {"type", "application/json"}}});
  if (more) {
    links.push_back({{"href", page_after(call, own, sections.back().id)},
                     {"rel", "next"},
                     {"type", "application/json"}});
  }
  return json_answer({{"job", job.id},
                      {"status", db::to_string(job.state)},
                      {"message", job.message},
                      {"sections", std::move(rows)},
                      {"numberMatched", total},
                      {"numberReturned", sections.size()},
                      {"links", links}});
}

Answer get_section(Site& site, const Call& call) {
  format(call, {"json"});
  const auto found = sections_or_problem(site.service.store, call.captured[0], {call.captured[1]});
  json document = section_detail(found.front(), site.service.data);
  const auto raster =
      site.service.store.raster(job_status_or_problem(site.service.store, call.captured[0]).raster);
  document["dem_sha256"] = raster ? json(raster->sha256) : json();
  return json_answer(document);
}

Answer get_section_log(Site& site, const Call& call) {
  constexpr int most_bytes = 4 << 20;
  const int tail = whole_number(call, "tail", most_bytes, 1, most_bytes);
  const auto found = sections_or_problem(site.service.store, call.captured[0], {call.captured[1]});
  const std::string& run = found.front().run;
  const auto file = site.service.data.run(run) / "log.txt";
  if (run.empty() || !std::filesystem::exists(file)) {
    throw Problem(Failure::no_such_resource, "no run of this section left a log");
  }
  Answer answer;
  answer.type = "text/plain; charset=utf-8";
  answer.body = site.service.data.without_root(end_of_log(file, tail));
  return answer;
}

Answer get_compare(Site& site, const Call& call) {
  const bool drawing = format(call, {"json", "svg"}) == "svg";
  const auto names = list(call, "sections");
  if (names.size() < 2 || names.size() > 20) {
    throw Problem(Failure::invalid_parameter,
                  "sections: give 2 to 20 names, for example sections=AA',BB'");
  }
  const bool curves = choice(call, "of", {"profiles", "curves"}) == "curves";
  const auto sections = sections_or_problem(site.service.store, call.captured[0], names);
  const db::Store& store = site.service.store;
  auto ensembles = ensembles_of(store, job_status_or_problem(store, call.captured[0]), sections);
  if (ensembles.size() < sections.size()) ensembles.clear();  // they are told together or not
  if (curves && ensembles.empty()) {
    throw Problem(Failure::no_such_result,
                  "of=curves: not each of the sections has an ensemble whose first look is over");
  }
  if (!drawing) {
    json document = compare_json(as_compared(sections));
    if (!ensembles.empty()) document["ensembles"] = compare_ensembles(ensembles);
    return json_answer(document);
  }
  Answer answer;
  answer.type = "image/svg+xml";
  answer.body = curves ? ensemble_svg(ensembles) : compare_svg(as_compared(sections));
  return answer;
}

Answer get_export(Site& site, const Call& call) {
  const auto wanted = format(call, {"gpkg", "geojson", "shp", "fgb"});
  return file_answer(site, call, finished_job(site, call.captured[0]), wanted);
}

Answer get_job_raster(Site& site, const Call& call) {
  const auto job = finished_job(site, call.captured[0]);
  const std::string& name = call.captured[1];
  const std::string tag = tag_of(job, name);
  if (has_already(call, tag)) return not_modified(tag);
  Answer answer;
  answer.file = raster_of(site.service.data, site.service.store, job, name);
  answer.type = answer.file.extension() == ".qml" ? "application/xml" : "image/tiff";
  answer.headers.emplace_back("ETag", tag);
  answer.headers.emplace_back("Content-Disposition", "attachment; filename=\"" + name + "\"");
  return answer;
}

}  // namespace leda::server
