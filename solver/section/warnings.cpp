#include "solver/section/warnings.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "solver/section/crest_and_toe.hpp"
#include "solver/section/fault_list.hpp"
#include "solver/section/seen_by_particles.hpp"
#include "solver/section/shear_at_rest.hpp"
#include "solver/section/toe_cut.hpp"
#include "solver/section/validate_field.hpp"

namespace leda {
namespace {

/// A thickness is rounded to whole rows of particles; up to this share it goes unsaid.
constexpr double most_rounding = 0.2;
/// A bank of few cells holds too long: a vertical cut fails at a stability number of 4.43 with 10
/// cells over its height, 4.17 with 20, 4.02 with 40; exact is 3.78 (tests/verification/README.md).
constexpr double few_cells_high = 8;
/// Of the ground, at the start. What lies deep and yields there alone moves no bank.
constexpr double most_beyond_strength = 0.5;

std::string rounded(double value) { return show(std::round(value * 100) / 100); }

std::string cell_that_sees(const Seen& seen, const Resolution& resolution) {
  const double rows_per_cell = resolution.cell_m / particle_spacing(resolution);
  const double cell = most_rounding * seen.thickness_m() * rows_per_cell;
  return "a cell of at most " + show(std::floor(cell * 1000 + 1e-6) / 1000) + " m sees it as it is";
}

void warn_of_rounding(const std::string& name, const Seen& seen, const Resolution& resolution,
                      std::vector<std::string>& warnings) {
  if (!seen.exists() || seen.lost()) return;
  const double missed = seen.missed_m / seen.length_m;
  if (std::abs(seen.seen_m2 / seen.area_m2 - 1) > most_rounding) {
    warnings.push_back(name + " is " + rounded(seen.thickness_m()) + " m thick and acts as " +
                       rounded(seen.seen_thickness_m()) + " m: particles stand " +
                       rounded(particle_spacing(resolution)) + " m apart; " +
                       cell_that_sees(seen, resolution));
  } else if (missed > most_rounding) {
    warnings.push_back(name + " is thinner than the particles' spacing (" +
                       rounded(particle_spacing(resolution)) + " m) along " +
                       show(std::round(100 * missed)) + " % of its length, where none sees it; " +
                       cell_that_sees(seen, resolution));
  }
}

void warn_of_thin_layers(const Section& section, const Resolution& resolution,
                         std::vector<std::string>& warnings) {
  for (const SeenLayer& entry : seen_layers(section, resolution)) {
    if (entry.continues) continue;
    const std::string& material = layers_of(section, entry.list)[entry.layer].material;
    std::string name = "layer " + std::to_string(entry.layer + 1) + " (" + material + ")";
    if (!section.columns.empty()) name += " of column " + std::to_string(entry.list + 1);
    warn_of_rounding(name, entry.seen, resolution, warnings);
  }
}

std::string place_of(const StrengthExtreme& extreme, Strength::By by) {
  return (by == Strength::By::depth ? "depths of " : "elevations of ") + rounded(extreme.from) +
         " to " + rounded(extreme.to) + " m";
}

/// Of the seams and hard bands of a table that particles miss along too much of their length the
/// weakest is told; a table of a sounding may have many.
void warn_of_missed_extremes(const Section& section, const Resolution& resolution,
                             const std::string& material, std::vector<std::string>& warnings) {
  std::vector<SeenExtreme> missed = seen_extremes(section, resolution, material);
  std::erase_if(missed, [](const SeenExtreme& one) {
    return one.seen.missed_m <= most_rounding * one.seen.length_m;
  });
  if (missed.empty()) return;
  const auto& [extreme, seen] = *std::ranges::min_element(
      missed, {}, [](const SeenExtreme& one) { return one.extreme.strength_Pa; });
  const double rows_per_cell = resolution.cell_m / particle_spacing(resolution);
  const double cell = std::floor(seen.thickness_m() * rows_per_cell * 1000 + 1e-6) / 1000;
  warnings.push_back(
      "material " + material + ": peak_strength_kPa " +
      (extreme.is_dip ? "falls to " : "rises to ") + rounded(extreme.strength_Pa / 1000) +
      " kPa at " + place_of(extreme, section.materials.at(material).peak_strength.by) +
      ", between two rows of particles (" + rounded(particle_spacing(resolution)) +
      " m apart) along " + show(std::round(100 * seen.missed_m / seen.length_m)) +
      " % of its length, where none has that strength; a cell of at most " + show(cell) +
      " m sees it" +
      (missed.size() > 1 ? " (and " + std::to_string(missed.size() - 1) + " more such)" : ""));
}

void warn_of_strength_tables(const Section& section, const Resolution& resolution,
                             std::vector<std::string>& warnings) {
  for (const auto& [name, material] : section.materials) {
    if (material.drains) continue;  // its strength is another one
    warn_of_missed_extremes(section, resolution, name, warnings);
  }
}

/// A material that no layer names changes nothing: a name misspelt elsewhere, or a layer forgotten.
void warn_of_unused_materials(const Section& section, std::vector<std::string>& warnings) {
  std::set<std::string> used;
  for (const Layer& layer : section.layers) used.insert(layer.material);
  for (const SoilColumn& column : section.columns) {
    for (const Layer& layer : column.layers) used.insert(layer.material);
  }
  for (const auto& [name, material] : section.materials) {
    if (!used.contains(name)) warnings.push_back("material '" + name + "' is in no layer");
  }
}

void warn_of_thin_cuts(const Section& section, const RunSettings& settings,
                       std::vector<std::string>& warnings) {
  if (const auto* excavation = std::get_if<ExcavationTrigger>(&settings.trigger)) {
    warn_of_rounding("the excavation",
                     seen_inside(section, settings.resolution, excavation->polygon),
                     settings.resolution, warnings);
    return;
  }
  const auto& cut = std::get<UndrainedTrigger>(settings.trigger).then_toe_cut_m;
  const auto bank = bank_in_use(section);
  if (!cut || !bank) return;
  warn_of_rounding("the toe cut",
                   seen_inside(section, settings.resolution, toe_cut(section, *bank, *cut)),
                   settings.resolution, warnings);
}

void warn_of_coarse_cells(const Section& section, double cell_m,
                          std::vector<std::string>& warnings) {
  const auto bank = bank_in_use(section);
  if (!bank) return;
  const double height = bank->crest.z - bank->toe.z;
  if (height / cell_m >= few_cells_high) return;
  warnings.push_back("the bank is " + rounded(height / cell_m) + " cells high (" + rounded(height) +
                     " m): with fewer than " + show(few_cells_high) +
                     " it stands longer and slides less than it would; a cell of at most " +
                     show(std::floor(height / few_cells_high * 1000 + 1e-6) / 1000) +
                     " m has them");
}

/// The water table lies below the base everywhere.
bool is_dry(const Section& section) {
  if (!section.water_table) return true;
  if (!section.water_table->depth_m) return false;
  const double highest = std::ranges::max(section.ground, {}, &Point::z).z;
  return highest - *section.water_table->depth_m <= section.base_m;
}

void warn_of_water(const Section& section, std::vector<std::string>& warnings) {
  if (!is_dry(section)) return;
  if (section.water_table) {
    warnings.push_back("the water table, " + show(*section.water_table->depth_m) +
                       " m below ground, lies below the base everywhere: the section is dry");
  }
  const double share = share_beyond_strength_at_rest(section);
  if (share < most_beyond_strength) return;
  warnings.push_back(
      "without water k0 acts on the total stress, and " + show(std::round(100 * share)) +
      " % of the ground begins beyond its strength, whatever the bank: say where the water stands "
      "(water_table), or give a k0 nearer to 1");
}

}  // namespace

std::vector<std::string> warnings_of(const Section& section, const RunSettings& settings) {
  std::vector<std::string> warnings;
  warn_of_coarse_cells(section, settings.resolution.cell_m, warnings);
  warn_of_thin_layers(section, settings.resolution, warnings);
  warn_of_strength_tables(section, settings.resolution, warnings);
  warn_of_thin_cuts(section, settings, warnings);
  warn_of_water(section, warnings);
  warn_of_unused_materials(section, warnings);
  warn_of_fields(section, settings.resolution, warnings);
  add_new(warnings, warnings_of(section.materials));
  return warnings;
}

void add_new(std::vector<std::string>& warnings, const std::vector<std::string>& more) {
  for (const std::string& warning : more) {
    if (std::ranges::find(warnings, warning) == warnings.end()) warnings.push_back(warning);
  }
}

}  // namespace leda
