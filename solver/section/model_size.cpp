#include "solver/section/model_size.hpp"

#include <cmath>

namespace leda {

double ground_area(const Section& section) {
  double area = 0;
  for (std::size_t i = 1; i < section.ground.size(); ++i) {
    const Point& a = section.ground[i - 1];
    const Point& b = section.ground[i];
    area += (b.x - a.x) * (0.5 * (a.z + b.z) - section.base_m);
  }
  return area;
}

double particles_of(const Section& section, const Resolution& resolution) {
  const double h = resolution.cell_m;
  return ground_area(section) / (h * h) * resolution.particles_per_cell;
}

double p_wave_speed(const Material& m) {
  const double bulk = m.youngs_modulus_Pa() / (3 * (1 - 2 * m.poisson_ratio));
  return std::sqrt((bulk + 4.0 / 3.0 * m.shear_modulus_Pa) / (m.unit_weight / gravity));
}

}  // namespace leda
