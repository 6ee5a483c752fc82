#include "server/http/handlers/job_document.hpp"

#include <nlohmann/json.hpp>

namespace leda::server {

nlohmann::json status_info(const db::JobStatus& job, const std::string& url) {
  const std::string own = url + "/jobs/" + job.id;
  nlohmann::json document = {{"jobID", job.id},          {"type", "process"},
                             {"processID", job.process}, {"status", db::to_string(job.state)},
                             {"message", job.message},   {"progress", job.progress},
                             {"created", job.created},   {"updated", job.updated}};
  if (!job.name.empty()) document["name"] = job.name;
  if (!job.started.empty()) document["started"] = job.started;
  if (!job.finished.empty()) document["finished"] = job.finished;
  const auto link = [&](const std::string& path, const char* rel, const char* title) {
    document["links"].push_back(
        {{"href", own + path}, {"rel", rel}, {"type", "application/json"}, {"title", title}});
  };
  link("", "self", "Status of the job");
  link("/sections", "related", "Sections of the job");
  if (job.state == db::JobState::successful) {
    link("/results", "http://www.opengis.net/def/rel/ogc/1.0/results", "Results of the job");
  }
  return document;
}

}  // namespace leda::server
