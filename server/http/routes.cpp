#include "server/http/routes.hpp"

#include <array>

#include "server/http/handlers/handlers.hpp"

namespace leda::server {
namespace {

constexpr std::array table{
    Route{"GET", "/", get_landing, "Landing page; for a browser the map page", "f",
          "landingPage text/html", Role::anyone},
    Route{"GET", "/page/{file}", get_page_file, "A file of the map page", "",
          "text/javascript text/css text/plain image/svg+xml", Role::anyone},
    Route{"GET", "/conformance", get_conformance, "Conformance classes", "f", "confClasses"},
    Route{"GET", "/api", get_api, "This interface as OpenAPI 3.0", "f",
          "application/vnd.oai.openapi+json;version=3.0"},

    Route{"GET", "/processes", get_processes, "What can be run", "f limit cursor", "processList"},
    Route{"GET", "/processes/{processID}", get_process, "A process and its schemas", "f",
          "process"},
    Route{"POST", "/processes/{processID}/execution", post_execution, "Start a job", "",
          "statusInfo", Role::submit},

    Route{"GET", "/jobs", get_jobs, "Jobs, newest first",
          "f type processID status datetime minDuration maxDuration limit cursor", "jobList"},
    Route{"GET", "/jobs/{jobID}", get_job, "Status of a job", "f", "statusInfo"},
    Route{"DELETE", "/jobs/{jobID}", delete_job, "Dismiss a job", "", "statusInfo", Role::submit},
    Route{"GET", "/jobs/{jobID}/results", get_results, "Results of a job", "f",
          "results text/csv image/svg+xml application/geo+json application/geopackage+sqlite3 "
          "application/zip"},
    Route{"GET", "/jobs/{jobID}/events", get_events, "Status as Server-Sent Events", "",
          "text/event-stream"},
    Route{"POST", "/jobs/{jobID}/retry", post_retry, "Run again what failed", "", "statusInfo",
          Role::submit},
    Route{"GET", "/jobs/{jobID}/sections", get_sections, "Sections of a job", "f limit cursor",
          "sectionList"},
    Route{"GET", "/jobs/{jobID}/sections/{name}", get_section,
          "A section: profile before and after, result, log", "f", "section"},
    Route{"GET", "/jobs/{jobID}/sections/{name}/log", get_section_log,
          "What the worker of its latest run wrote", "tail", "text/plain"},
    Route{"GET", "/jobs/{jobID}/sections/{name}/ensemble", get_section_ensemble,
          "How sure: what the members of a section say together", "f",
          "sectionEnsemble image/svg+xml"},
    Route{"GET", "/jobs/{jobID}/members", get_members,
          "Members of an ensemble: inputs, weight, distances, cost", "f", "text/csv"},
    Route{"GET", "/jobs/{jobID}/compare", get_compare, "Two sections side by side", "f of sections",
          "comparison image/svg+xml"},
    Route{"GET", "/jobs/{jobID}/sections/{name}/frames", get_frames,
          "The particles of its latest run over time", "field first count",
          "application/octet-stream"},
    Route{"GET", "/jobs/{jobID}/sections/{name}/fields.h5", get_fields,
          "The particles of its latest run as HDF5", "", "application/x-hdf5"},
    Route{"GET", "/jobs/{jobID}/map", get_job_map,
          "Sections and zones in the DEM's CRS, for drawing", "", "application/vnd.leda.map+json"},
    Route{"GET", "/jobs/{jobID}/export", get_export, "Sections and zones as a file", "f",
          "application/geopackage+sqlite3 application/geo+json application/zip"},

    Route{"GET", "/jobs/{jobID}/rasters/{file}", get_job_raster,
          "release_probability.tif or runout_probability.tif, or with .qml its style for QGIS", "",
          "image/tiff application/xml"},

    Route{"POST", "/rasters", post_raster, "Register a DEM: the body is a GeoTIFF",
          "name vertical_unit epsg nodata", "raster", Role::submit},
    Route{"GET", "/rasters", get_rasters, "Registered DEMs", "f", "rasterList"},
    Route{"GET", "/rasters/{rasterID}", get_raster, "A registered DEM", "f", "raster"},
    Route{"PATCH", "/rasters/{rasterID}", patch_raster, "Rename a DEM", "", "raster", Role::submit},
    Route{"DELETE", "/rasters/{rasterID}", delete_raster, "Remove a DEM that no job needs", "", "",
          Role::submit},
    Route{"GET", "/rasters/{rasterID}/hillshade.png", get_hillshade, "A shaded picture of a DEM",
          "", "image/png"},

    Route{"POST", "/rasters/{rasterID}/layout", post_layout,
          "Sections as they would be cut: profile, crest, toe", "", "layout"},
    Route{"GET", "/rasters/{rasterID}/elevation", get_elevation, "Ground at a point of a DEM", "at",
          "elevation"},

    Route{"GET", "/collections", get_collections, "Layers of the map", "f", "collections"},
    Route{"GET", "/collections/{collectionID}", get_collection, "A layer", "f", "collection"},
    Route{"GET", "/collections/{collectionID}/schema", get_schema, "Properties of its features",
          "f", "application/schema+json"},
    Route{"GET", "/collections/{collectionID}/items", get_items, "Features of a layer",
          "f bbox limit cursor job datetime", "featureCollectionGeoJSON"},
    Route{"GET", "/collections/{collectionID}/items/{featureID}", get_item, "A feature", "f",
          "featureGeoJSON"},

    Route{"POST", "/purge", post_purge, "Remove what old jobs left", "older_than_days jobs",
          "purged", Role::admin},
    Route{"GET", "/healthz", get_healthz, "The process lives", "", "health", Role::anyone},
    Route{"GET", "/readyz", get_readyz, "The store answers and jobs are run", "", "health",
          Role::anyone},
    Route{"GET", "/metrics", get_metrics, "Counters in the Prometheus text format", "",
          "text/plain"},
};

}  // namespace

std::span<const Route> routes() { return table; }

}  // namespace leda::server
