#include "server/layers/probability_rasters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "profiles/dem.hpp"
#include "profiles/probability_raster.hpp"
#include "server/layers/job_ensemble.hpp"
#include "server/layers/region_layers.hpp"
#include "server/layers/region_quantiles.hpp"
#include "server/operate/problem.hpp"

namespace leda::server {
namespace {

constexpr double usual_cell_m = 2;

/// Hundredths: finer than 512 members know a probability.
std::vector<double> every_hundredth() {
  std::vector<double> exceedance;
  for (int percent = 1; percent < 100; ++percent) exceedance.push_back(percent / 100.0);
  return exceedance;
}

double metres_per_unit_of(const DataFolder& data, const db::Store& store,
                          const db::JobStatus& job) {
  const auto raster = store.raster(job.raster);
  if (!raster || !raster->removed.empty()) {
    throw Problem(Failure::wrong_state, "the DEM of job " + job.id + " was removed");
  }
  return profiles::Dem::open(data.root() / raster->file, {}).info().metres_per_unit;
}

std::vector<Zone> of_kind(std::vector<Zone> zones, ZoneKind kind) {
  std::erase_if(zones, [&](const Zone& zone) { return zone.kind != kind; });
  return zones;
}

std::string described(const db::JobStatus& job, ZoneKind kind) {
  return fmt::format(
      "Probability that ground is reached ({}), {}; in hundredths, rounded down. Job {} of region "
      "{}",
      to_string(kind), ensemble_condition, job.id, job.name);
}

}  // namespace

std::string raster_name(ZoneKind kind) { return std::string(to_string(kind)) + "_probability.tif"; }

std::optional<ZoneKind> raster_kind_from(const std::string& name) {
  for (const ZoneKind kind : {ZoneKind::release, ZoneKind::runout}) {
    const std::filesystem::path raster(raster_name(kind));
    if (name == raster || name == raster.stem().string() + ".qml") return kind;
  }
  return std::nullopt;
}

void write_probability_raster(const DataFolder& data, const db::Store& store,
                              const db::JobStatus& job, ZoneKind kind,
                              const std::filesystem::path& file) {
  const auto ensemble = ensemble_or_problem(store, job);
  profiles::ProbabilityRaster raster;
  raster.kind = kind;
  raster.epsg = epsg_of(store, job);
  if (raster.epsg == 0) {
    throw Problem(Failure::wrong_state, "job " + job.id + " has no map: it is a " + job.process);
  }
  profiles::ZonationOptions options;
  options.metres_per_unit = metres_per_unit_of(data, store, job);
  raster.cell =
      ensemble.asked().asked.raster_cell_m.value_or(usual_cell_m) / options.metres_per_unit;
  const auto exceedance = every_hundredth();
  const auto quantiles = region_quantiles(store, ensemble.asked(), ensemble.soil(),
                                          store.sections(job.id), exceedance);
  raster.zones = of_kind(profiles::probability_zones(quantiles, exceedance, options), kind);
  for (const Zone& zone : of_kind(profiles::zones_spoken_of(quantiles, options), kind)) {
    raster.spoken_for.insert(raster.spoken_for.end(), zone.area.begin(), zone.area.end());
  }
  raster.description = described(job, kind);
  profiles::write_probability_raster(raster, file);
}

}  // namespace leda::server
