#include "server/jobs/run_size.hpp"

#include <algorithm>

#include "solver/section/model_size.hpp"

namespace leda::server {
namespace {

// Measured on one core of a server processor (solver/measurements.md): 8 to 14 ns.
constexpr double ns_per_particle_step = 12;
constexpr db::TypicalRun without_history{0, 40, 0, 0};
// Bytes of a particle in a frame of fields.h5, deflated, and in the checkpoint.
constexpr double frame_bytes = 40, checkpoint_bytes = 130;
constexpr double folder_bytes = 100e3;  // documents, log, profile

}  // namespace

RunSize run_size(const Section& section, const RunSettings& settings) {
  const double h = settings.resolution.cell_m;
  double fastest = 0;
  for (std::size_t list = 0; list < layer_lists(section); ++list) {
    for (const Layer& layer : layers_of(section, list)) {
      const auto material = section.materials.find(layer.material);
      if (material != section.materials.end()) {
        fastest = std::max(fastest, p_wave_speed(material->second));
      }
    }
  }
  RunSize size;
  size.particles = std::max(particles_of(section, settings.resolution), 0.0);
  size.steps_per_simulated_s = fastest / (settings.time_step_factor * h);
  size.ns_per_particle_step = ns_per_particle_step;
  size.longest_s = settings.stop.max_time_s;
  const double interval = settings.output.frame_interval_s;
  if (interval > 0) size.frames += settings.stop.max_time_s / interval;
  return size;
}

db::TypicalRun typical_or_default(const std::optional<db::TypicalRun>& measured) {
  return measured.value_or(without_history);
}

RunCost cost_of(const RunSize& size, const db::TypicalRun& typical) {
  const double ns = typical.runs > 0 ? typical.ns_per_particle_step : size.ns_per_particle_step;
  const double core_s_per_simulated_s = size.particles * size.steps_per_simulated_s * ns * 1e-9;
  RunCost cost;
  cost.likely_core_s = core_s_per_simulated_s * std::min(typical.simulated_s, size.longest_s);
  cost.longest_core_s = core_s_per_simulated_s * std::max(typical.simulated_s, size.longest_s);
  cost.disk_bytes = folder_bytes + size.particles * (size.frames * frame_bytes + checkpoint_bytes);
  return cost;
}

}  // namespace leda::server
