#include "server/routes.hpp"

#include <array>

#include "server/handlers/handlers.hpp"

namespace leda::server {
namespace {

constexpr std::array table{
    Route{"GET", "/", get_landing, "Landing page", "f"},
    Route{"GET", "/conformance", get_conformance, "Conformance classes", "f"},
    Route{"GET", "/api", get_api, "This interface as OpenAPI 3.0", "f"},

    Route{"GET", "/processes", get_processes, "What can be run", "f limit"},
    Route{"GET", "/processes/{processID}", get_process, "A process and its schemas", "f"},
    Route{"POST", "/processes/{processID}/execution", post_execution, "Start a job"},

    Route{"GET", "/jobs", get_jobs, "Jobs, newest first",
          "f type processID status datetime limit offset"},
    Route{"GET", "/jobs/{jobID}", get_job, "Status of a job", "f"},
    Route{"DELETE", "/jobs/{jobID}", delete_job, "Dismiss a job"},
    Route{"GET", "/jobs/{jobID}/results", get_results, "Results of a job", "f"},
    Route{"GET", "/jobs/{jobID}/events", get_events, "Status as Server-Sent Events"},
    Route{"POST", "/jobs/{jobID}/retry", post_retry, "Run again what failed"},
    Route{"GET", "/jobs/{jobID}/sections", get_sections, "Sections of a job", "f"},
    Route{"GET", "/jobs/{jobID}/sections/{name}", get_section,
          "A section: profile before and after, result, log", "f"},
    Route{"GET", "/jobs/{jobID}/compare", get_compare, "Two sections side by side", "f sections"},
    Route{"GET", "/jobs/{jobID}/export", get_export, "Sections and zones as a file", "f"},

    Route{"POST", "/rasters", post_raster, "Register a DEM: the body is a GeoTIFF",
          "name vertical_unit epsg"},
    Route{"GET", "/rasters", get_rasters, "Registered DEMs", "f"},
    Route{"GET", "/rasters/{rasterID}", get_raster, "A registered DEM", "f"},
    Route{"GET", "/rasters/{rasterID}/hillshade.png", get_hillshade, "A shaded picture of a DEM"},

    Route{"GET", "/collections", get_collections, "Layers of the map", "f"},
    Route{"GET", "/collections/{collectionID}", get_collection, "A layer", "f"},
    Route{"GET", "/collections/{collectionID}/schema", get_schema, "Properties of its features",
          "f"},
    Route{"GET", "/collections/{collectionID}/items", get_items, "Features of a layer",
          "f bbox limit offset job datetime"},
    Route{"GET", "/collections/{collectionID}/items/{featureID}", get_item, "A feature", "f"},

    Route{"GET", "/healthz", get_healthz, "The process lives"},
    Route{"GET", "/readyz", get_readyz, "The store answers"},
    Route{"GET", "/metrics", get_metrics, "Counters in the Prometheus text format"},
};

}  // namespace

std::span<const Route> routes() { return table; }

}  // namespace leda::server
