#pragma once
// One function a route: parse, call, answer. Each throws Problem where it can't answer.

#include "server/http/answer.hpp"

namespace leda::server {

struct Service;

// landing.cpp
Answer get_landing(Service& service, const Call& call);
Answer get_conformance(Service& service, const Call& call);
Answer get_api(Service& service, const Call& call);

// processes.cpp
Answer get_processes(Service& service, const Call& call);
Answer get_process(Service& service, const Call& call);
Answer post_execution(Service& service, const Call& call);

// jobs.cpp
Answer get_jobs(Service& service, const Call& call);
Answer get_job(Service& service, const Call& call);
Answer delete_job(Service& service, const Call& call);
Answer post_retry(Service& service, const Call& call);

// events.cpp
Answer get_events(Service& service, const Call& call);

// results.cpp
Answer get_results(Service& service, const Call& call);
Answer get_sections(Service& service, const Call& call);
Answer get_section(Service& service, const Call& call);
Answer get_section_log(Service& service, const Call& call);
Answer get_compare(Service& service, const Call& call);
Answer get_export(Service& service, const Call& call);

// rasters.cpp
Answer post_raster(Service& service, const Call& call);
Answer get_rasters(Service& service, const Call& call);
Answer patch_raster(Service& service, const Call& call);
Answer delete_raster(Service& service, const Call& call);
Answer get_raster(Service& service, const Call& call);
Answer get_hillshade(Service& service, const Call& call);

// collections.cpp
Answer get_collections(Service& service, const Call& call);
Answer get_collection(Service& service, const Call& call);
Answer get_schema(Service& service, const Call& call);
Answer get_items(Service& service, const Call& call);
Answer get_item(Service& service, const Call& call);

// retention.cpp
Answer post_purge(Service& service, const Call& call);

// health.cpp
Answer get_healthz(Service& service, const Call& call);
Answer get_readyz(Service& service, const Call& call);
Answer get_metrics(Service& service, const Call& call);

}  // namespace leda::server
