#include "server/jobs/service.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "server/documents/execute_options.hpp"
#include "server/jobs/dry_run.hpp"
#include "server/jobs/executors/slurm/shared_folder.hpp"
#include "server/jobs/executors/slurm/slurm_executor.hpp"
#include "server/layers/features.hpp"
#include "server/operate/logging.hpp"
#include "server/operate/memory_return.hpp"
#include "server/operate/problem.hpp"

namespace leda::server {
namespace {

/// "20260131T120000-1a2b3c": sorts by time, and is safe in a path.
std::string new_job_id() {
  std::string id;
  for (const char c : db::utc_now().substr(0, 19)) {
    if (c != '-' && c != ':') id += c;
  }
  return id + "-" + random_hex(6);
}

/// The name a user gave the job, from the request as sent.
std::string name_in(const std::string& request) {
  const auto document = nlohmann::json::parse(request, nullptr, false);
  const auto at = nlohmann::json::json_pointer("/inputs/name");
  if (document.is_object() && document.contains(at) && document[at].is_string()) {
    return document[at].get<std::string>();
  }
  return "";
}

void refuse_unknown_outputs(const Process& process, const std::string& request) {
  const auto described = process.describe();
  const auto& known = described.at("outputs");
  std::vector<Fault> faults;
  for (const auto& name : execute_options_of(request).outputs) {
    if (known.contains(name)) continue;
    faults.push_back(
        {"/outputs/" + pointer_part(name), "is not an output of " + std::string(process.id) +
                                               ": see GET /processes/" + std::string(process.id)});
  }
  if (!faults.empty()) {
    throw Problem(Failure::invalid_request, "the request cannot be understood", faults);
  }
}

std::unique_ptr<Work> opened(const Service& service, const Process& process,
                             const std::string& request) {
  auto work = process.open(request, {service.data, service.store});
  refuse_unknown_outputs(process, request);
  return work;
}

void refuse_too_large(const Service& service, const Work& work,
                      const std::vector<db::SectionRecord>& sections) {
  const auto members = static_cast<std::size_t>(std::ranges::count_if(
      sections, [](const auto& section) { return section.member.has_value(); }));
  const std::size_t own = sections.size() - members;
  if (own > service.limits.sections) {
    throw Problem(Failure::invalid_request,
                  fmt::format("the job has {} sections, more than {}: split it", own,
                              service.limits.sections));
  }
  if (members > service.limits.members) {
    throw Problem(Failure::invalid_request,
                  fmt::format("the job has {} members of {} sections, more than {}: take fewer "
                              "members or sections, or split it",
                              members, own, service.limits.members),
                  {{"/inputs/ensemble/stop/max_members", "makes too many members for one job"}});
  }
  const double particles = particles_of(work, sections);
  if (particles > service.limits.particles) {
    throw Problem(Failure::invalid_request,
                  fmt::format("the job has about {:.3g} particles, more than {:.3g}: take larger "
                              "cells, fewer sections, or split it",
                              particles, service.limits.particles),
                  {{"/inputs/resolution/cell_m", "makes too many particles for one job"}});
  }
}

/// A job that is being laid out or put back counts as one that is unfinished: however many are sent
/// at once, no more are taken than may be unfinished.
/// @return held until it stands in the store as unfinished
Slots::Slot slot_of_new_job(Service& service) {
  auto slot = service.layouts.take();
  if (!slot) throw Problem(Failure::too_busy, "other jobs are being laid out: try again soon");
  db::JobFilter unfinished;
  unfinished.states = {db::JobState::accepted, db::JobState::running};
  const auto jobs = static_cast<std::size_t>(service.store.count_jobs(unfinished));
  if (jobs + service.layouts.taken() > service.limits.unfinished_jobs) {
    throw Problem(Failure::queue_full, "too many jobs are unfinished: try again later");
  }
  return slot;
}

std::optional<Submitted> stored_reply(const db::Store& store, const Process& process,
                                      const std::string& request, const std::string& key) {
  if (key.empty()) return std::nullopt;
  const auto job = store.job_by_idempotency_key(key);
  if (!job) return std::nullopt;
  if (job->process != process.id || job->request != request) {
    throw Problem(Failure::key_reused,
                  "the Idempotency-Key was used before with another request: job " + job->id);
  }
  return Submitted{*job, true};
}

template <class Job>
Job found_or_problem(std::optional<Job> job, const std::string& id) {
  if (!job) throw Problem(Failure::no_such_job, "there is no job " + id);
  return std::move(*job);
}

DataFolder opened(const std::filesystem::path& data_folder, const ServiceOptions& options) {
  const auto& shared = options.slurm.shared_folder;
  if (options.runs_on == RunsOn::slurm && !shared.empty()) put_runs_in(data_folder, shared);
  return DataFolder(data_folder);
}

std::unique_ptr<Executor> executor(const ServiceOptions& options, const DataFolder& data) {
  if (options.runs_on == RunsOn::this_machine) {
    return std::make_unique<LocalExecutor>(options.program, options.workers, options.run_limits);
  }
  const auto& shared = options.slurm.shared_folder;
  return std::make_unique<SlurmExecutor>(options.slurm.program, options.slurm, options.run_limits,
                                         (shared.empty() ? data.root() : shared) / "arrays");
}

}  // namespace

Service::Service(const std::filesystem::path& data_folder, const ServiceOptions& options)
    : limits(options.limits),
      data(opened(data_folder, options)),
      lock(data),
      store(data.store()),
      dispatcher(data, store, [options, this] { return executor(options, data); },
                 {[this](const SectionResult& result) { metrics.count_run(result); },
                  [this](int runs) { metrics.count_restarts(runs); }}) {
  // Jobs of an older Leda, and one whose server was killed between two lines of submit().
  for (const auto& id : store.jobs_without_boxes()) {
    const auto job = store.job_status(id).value();
    keep_section_boxes(store, job);
    keep_zone_boxes(store, job);
  }
  dispatcher.start();
}

Submitted submit(Service& service, const Process& process, const std::string& request,
                 const std::string& key) {
  if (auto stood = stored_reply(service.store, process, request, key)) return *stood;
  const MemoryReturn after_the_layout;
  const auto slot = slot_of_new_job(service);
  const auto work = opened(service, process, request);
  const auto sections = work->plan();
  refuse_too_large(service, *work, sections);

  const std::lock_guard one_at_a_time(service.submitting);
  if (auto stood = stored_reply(service.store, process, request, key)) return *stood;
  db::JobRecord job;
  job.id = new_job_id();
  job.process = process.id;
  job.name = name_in(request);
  job.message = "accepted";
  job.request = request;
  job.idempotency_key = key;
  job.raster = work->raster();
  job.created = job.updated = db::utc_now();
  service.store.add_job(job);
  service.store.set_sections(job.id, sections);
  keep_section_boxes(service.store, job);
  service.dispatcher.add(job.id);
  log_info(job.id, "accepted process={} runs={} name={}", process.id, sections.size(),
           in_quotes(job.name));
  return {job, false};
}

nlohmann::json dry_run(Service& service, const Process& process, const std::string& request) {
  const MemoryReturn after_the_layout;
  const auto slot = slot_of_new_job(service);
  const auto work = opened(service, process, request);
  auto sections = work->plan();
  refuse_too_large(service, *work, sections);
  return dry_run(process, *work, std::move(sections), service.store);
}

db::JobStatus retry(Service& service, const std::string& id) {
  const db::JobStatus job = job_status_or_problem(service.store, id);
  if (!db::is_final(job.state) || job.state == db::JobState::dismissed) {
    throw Problem(Failure::wrong_state, "job " + id + " is " + db::to_string(job.state) +
                                            ": only a finished job can be retried");
  }
  const auto raster = service.store.raster(job.raster);
  if (raster && !raster->removed.empty()) {
    throw Problem(Failure::wrong_state, "the DEM of job " + id + " was removed on " +
                                            raster->removed + ": register it again first");
  }
  const auto slot = slot_of_new_job(service);
  if (service.store.retry_job(id) == 0) {
    throw Problem(Failure::wrong_state, "no section of job " + id + " failed");
  }
  service.dispatcher.add(id);
  log_info(id, "retried");
  return job_status_or_problem(service.store, id);
}

db::JobRecord job_or_problem(const db::Store& store, const std::string& id) {
  return found_or_problem(store.job(id), id);
}

db::JobStatus job_status_or_problem(const db::Store& store, const std::string& id) {
  return found_or_problem(store.job_status(id), id);
}

}  // namespace leda::server
