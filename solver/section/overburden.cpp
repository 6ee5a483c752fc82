#include "solver/section/overburden.hpp"

#include <algorithm>

namespace leda {

double overburden(const Section& section, Point p) {
  double top = elevation_at(section.ground, p.x), weight = 0;
  for (const Layer& layer : layers_at(section, p.x)) {
    if (top <= p.z) break;
    const double to = std::max(std::min(layer_bottom(section, layer, p.x), top), p.z);
    weight += section.materials.at(layer.material).unit_weight * (top - to);
    top = to;
  }
  return weight;
}

}  // namespace leda
