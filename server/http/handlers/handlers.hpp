#pragma once
// One function a route: parse, call, answer. Each throws Problem where it can't answer.

#include "server/http/answer.hpp"

namespace leda::server {

struct Site;

// landing.cpp
Answer get_landing(Site& site, const Call& call);
Answer get_conformance(Site& site, const Call& call);
Answer get_api(Site& site, const Call& call);

// page.cpp
Answer get_page_file(Site& site, const Call& call);

// processes.cpp
Answer get_processes(Site& site, const Call& call);
Answer get_process(Site& site, const Call& call);
Answer post_execution(Site& site, const Call& call);

// jobs.cpp
Answer get_jobs(Site& site, const Call& call);
Answer get_job(Site& site, const Call& call);
Answer delete_job(Site& site, const Call& call);
Answer post_retry(Site& site, const Call& call);

// events.cpp
Answer get_events(Site& site, const Call& call);

// results.cpp
Answer get_results(Site& site, const Call& call);
Answer get_sections(Site& site, const Call& call);
Answer get_section(Site& site, const Call& call);
Answer get_section_log(Site& site, const Call& call);
Answer get_compare(Site& site, const Call& call);
Answer get_export(Site& site, const Call& call);
Answer get_job_raster(Site& site, const Call& call);

// job_map.cpp
Answer get_job_map(Site& site, const Call& call);

// frames.cpp
Answer get_frames(Site& site, const Call& call);
Answer get_fields(Site& site, const Call& call);

// ensembles.cpp
Answer get_section_ensemble(Site& site, const Call& call);
Answer get_members(Site& site, const Call& call);

// rasters.cpp
Answer post_raster(Site& site, const Call& call);
Answer get_rasters(Site& site, const Call& call);
Answer patch_raster(Site& site, const Call& call);
Answer delete_raster(Site& site, const Call& call);
Answer get_raster(Site& site, const Call& call);
Answer get_hillshade(Site& site, const Call& call);

// layout.cpp
Answer post_layout(Site& site, const Call& call);
Answer get_elevation(Site& site, const Call& call);

// collections.cpp
Answer get_collections(Site& site, const Call& call);
Answer get_collection(Site& site, const Call& call);
Answer get_schema(Site& site, const Call& call);
Answer get_items(Site& site, const Call& call);
Answer get_item(Site& site, const Call& call);

// retention.cpp
Answer post_purge(Site& site, const Call& call);

// health.cpp
Answer get_healthz(Site& site, const Call& call);
Answer get_readyz(Site& site, const Call& call);
Answer get_metrics(Site& site, const Call& call);

}  // namespace leda::server
