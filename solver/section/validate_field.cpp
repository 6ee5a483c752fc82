#include "solver/section/validate_field.hpp"

#include <algorithm>

namespace leda {
namespace {

/// Undrained strengths within a layer have 0.06 to 0.8 (Phoon and Kulhawy 1999).
constexpr double most_cov = 1;
/// A particle has the strength at its middle: variation within fewer cells is seen by some only.
constexpr double cells_of_a_scale = 2;
/// Soils have 0.2 to 100 m.
constexpr double least_scale_m = 0.01, most_scale_m = 1e5;

struct Scale {
  const char* key;
  double value, extent;
  const char* of;  ///< the section's extent
};

void warn_of_scale(const std::string& field, const Scale& scale, double cell_m,
                   std::vector<std::string>& warnings) {
  const std::string is = field + scale.key + " is " + show(scale.value) + " m: ";
  if (scale.value < cells_of_a_scale * cell_m) {
    warnings.push_back(is + "strength varies within less than " + show(cells_of_a_scale) +
                       " cells of " + show(cell_m) +
                       " m, which is not averaged over them; a cell of at most " +
                       show(scale.value / cells_of_a_scale) + " m follows it");
  } else if (scale.value > scale.extent) {
    warnings.push_back(is + "longer than the section's " + scale.of + " (" + show(scale.extent) +
                       " m), within which the strength hardly varies");
  }
}

}  // namespace

void check_field(const Material& m, const std::string& at, FaultList& faults) {
  const RandomField& field = *m.field;
  if (m.drains) {
    faults.add(at + "/field",
               "is given for ground that drains: it is of the undrained peak strength");
  }
  faults.within(at + "/field/cov", field.cov, field.cov > 0 && field.cov <= most_cov,
                "greater than 0 and at most " + show(most_cov) +
                    ": standard deviation over mean, a fraction (clays have 0.06 to 0.8)");
  const auto check_scale = [&](const char* key, double scale) {
    faults.within(at + key, scale, scale >= least_scale_m && scale <= most_scale_m,
                  show(least_scale_m) + " to " + show(most_scale_m) +
                      " m: the scale of fluctuation, twice the length over which the correlation "
                      "falls to 1/e");
  };
  check_scale("/field/horizontal_m", field.horizontal_m);
  check_scale("/field/vertical_m", field.vertical_m);
}

void warn_of_fields(const Section& section, const Resolution& resolution,
                    std::vector<std::string>& warnings) {
  const double length = section.ground.back().x - section.ground.front().x;
  const double height = std::ranges::max(section.ground, {}, &Point::z).z - section.base_m;
  for (const auto& [name, m] : section.materials) {
    if (!m.field) continue;
    const std::string field = "material " + name + ": field/";
    warn_of_scale(field, {"horizontal_m", m.field->horizontal_m, length, "length"},
                  resolution.cell_m, warnings);
    warn_of_scale(field, {"vertical_m", m.field->vertical_m, height, "height"}, resolution.cell_m,
                  warnings);
  }
}

}  // namespace leda
