#pragma once
// Colours of probabilities on a map, after ColorBrewer: YlOrRd for release, PuBu for runout. No
// green, which reads as safe.

#include <array>
#include <cstddef>

#include "profiles/map/zone.hpp"

namespace leda::profiles {

struct Colour {
  int red = 0, green = 0, blue = 0;
};

/// Upper ends of the classes that have a colour of their own; beyond the last: the fifth.
inline constexpr std::array probability_classes{0.05, 0.2, 0.5, 0.8};

inline constexpr std::array<Colour, 5> release_colours{
    {{255, 255, 178}, {254, 204, 92}, {253, 141, 60}, {240, 59, 32}, {189, 0, 38}}};
inline constexpr std::array<Colour, 5> runout_colours{
    {{241, 238, 246}, {189, 201, 225}, {116, 169, 207}, {43, 140, 190}, {4, 90, 141}}};

inline Colour probability_colour(ZoneKind kind, double probability) {
  std::size_t colour = 0;
  while (colour < probability_classes.size() && probability > probability_classes[colour]) ++colour;
  return (kind == ZoneKind::release ? release_colours : runout_colours)[colour];
}

}  // namespace leda::profiles
