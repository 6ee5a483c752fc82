#pragma once
// What particles see of a thin body of ground. They stand on a square lattice (solver/README.md,
// seeds): what lies between two of its rows does not exist for them, and a body thicker than that
// counts as whole rows.

#include <string>
#include <vector>

#include "solver/section/run_settings.hpp"
#include "solver/section/section.hpp"
#include "solver/section/strength_extremes.hpp"

namespace leda {

/// A body of ground, and the particles in it.
struct Seen {
  double area_m2 = 0;
  double seen_m2 = 0;   ///< area of the particles in it
  double length_m = 0;  ///< along the section, where the body is
  double missed_m = 0;  ///< of that, where no particle is in it

  bool exists() const { return area_m2 > 0; }
  bool lost() const { return exists() && seen_m2 == 0; }
  double thickness_m() const { return exists() ? area_m2 / length_m : 0; }
  double seen_thickness_m() const { return exists() ? seen_m2 / length_m : 0; }
};

/// Distance between two rows of particles, m.
double particle_spacing(const Resolution& resolution);

/// A layer of one of the section's lists, and the particles in it.
struct SeenLayer {
  std::size_t list = 0;
  std::size_t layer = 0;  ///< in its list
  Seen seen;
  bool continues = false;  ///< into one beside it of the same material: it is no body of its own
};

/// One entry a layer, list by list in their order.
/// @pre ground, layers and resolution have no fault
std::vector<SeenLayer> seen_layers(const Section& section, const Resolution& resolution);

/// A seam or a hard band that a material's table of strength draws, and the particles in it.
struct SeenExtreme {
  StrengthExtreme extreme;
  Seen seen;  ///< where the extreme itself lies within the material
};

/// One entry an extreme of the table; none of a constant strength.
/// @param material one of the section's
/// @pre as seen_layers; the material has no fault
std::vector<SeenExtreme> seen_extremes(const Section& section, const Resolution& resolution,
                                       const std::string& material);

/// The ground inside a polygon.
/// @pre as seen_layers; the polygon does not cross itself
Seen seen_inside(const Section& section, const Resolution& resolution, const Polyline& polygon);

/// Whether a material has ground below the water table, in any column of particles: between two
/// points of the ground it may have a column or a lens of its own.
/// @pre as seen_layers
bool lies_under_water(const Section& section, const Resolution& resolution,
                      const std::string& material);

}  // namespace leda
