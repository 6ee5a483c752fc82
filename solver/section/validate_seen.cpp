#include "solver/section/validate_seen.hpp"

#include <cmath>

#include "solver/section/seen_by_particles.hpp"
#include "solver/section/toe_cut.hpp"
#include "solver/section/validate_section.hpp"

namespace leda {
namespace {

std::string lost_to(const Resolution& resolution, const Seen& seen) {
  const double rows_per_cell = resolution.cell_m / particle_spacing(resolution);
  const double cell = std::floor(seen.thickness_m() * rows_per_cell * 1000 + 1e-6) / 1000;
  return "holds no particle: it is " + show(std::round(seen.thickness_m() * 1000) / 1000) +
         " m thick where it is, and particles stand " + show(particle_spacing(resolution)) +
         " m apart; take a cell of at most " + show(cell) + " m";
}

/// A column between two rows of particles would be no ground at all.
void check_seen_columns(const Section& section, const Resolution& resolution, FaultList& faults) {
  for (std::size_t i = 0; i < section.columns.size(); ++i) {
    const double width = section.columns[i].to_m - section.columns[i].from_m;
    if (width >= resolution.cell_m * (1 - 1e-9)) continue;
    faults.add("/columns/" + std::to_string(i), "is " + show(width) +
                                                    " m wide, must be at least one cell (" +
                                                    show(resolution.cell_m) + " m)");
  }
}

void check_seen_layers(const Section& section, const Resolution& resolution, FaultList& faults) {
  for (const SeenLayer& entry : seen_layers(section, resolution)) {
    if (!entry.seen.lost() || entry.continues) continue;
    faults.add(layers_pointer(section, entry.list) + "/" + std::to_string(entry.layer),
               "(" + layers_of(section, entry.list)[entry.layer].material + ") " +
                   lost_to(resolution, entry.seen) + ", or leave the layer out");
  }
}

}  // namespace

void check_seen(const Section& section, const RunSettings& settings,
                const std::optional<CrestAndToe>& bank, FaultList& faults) {
  const Resolution& resolution = settings.resolution;
  check_seen_columns(section, resolution, faults);
  check_seen_layers(section, resolution, faults);
  if (const auto* excavation = std::get_if<ExcavationTrigger>(&settings.trigger)) {
    const Seen cut = seen_inside(section, resolution, excavation->polygon);
    if (cut.seen_m2 == 0) faults.add("/trigger/polygon", lost_to(resolution, cut));
    return;
  }
  const auto& height = std::get<UndrainedTrigger>(settings.trigger).then_toe_cut_m;
  if (!height || !bank) return;
  const Seen cut = seen_inside(section, resolution, toe_cut(section, *bank, *height));
  if (cut.seen_m2 > 0) return;
  faults.add("/trigger/then_toe_cut_m",
             "is " + show(*height) + " m: " +
                 (cut.exists() ? "the cut " + lost_to(resolution, cut)
                               : "the face at the toe is as steep as that already, no ground "
                                 "lies in front of it to be cut"));
}

void check_weight_under_water(const Section& section, const Resolution& resolution,
                              FaultList& faults) {
  for (const auto& [name, material] : section.materials) {
    if (material.unit_weight > water_unit_weight) continue;
    if (!lies_under_water(section, resolution, name)) continue;
    faults.add("/materials/" + pointer_part(name) + "/unit_weight_kN_m3",
               "is " + show(material.unit_weight / 1000) +
                   " kN/m3, must be more than that of water (9.81) below the water table: the "
                   "total weight, water included, not the submerged one");
  }
}

}  // namespace leda
