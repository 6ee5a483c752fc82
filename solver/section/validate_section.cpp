#include "solver/section/validate_section.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace leda {
namespace {

/// A crest or toe typed by hand may be off the ground line by this much, m.
constexpr double on_ground = 0.05;

std::string index(std::size_t i) { return std::string("/").append(std::to_string(i)); }

bool runs_from_right_to_left(const Polyline& line) {
  return line.size() > 1 && line.back().x < line.front().x &&
         std::ranges::is_sorted(line, std::ranges::greater{}, &Point::x);
}

bool check_line(const Polyline& line, const std::string& at, FaultList& faults) {
  bool sound = true;
  if (runs_from_right_to_left(line)) {
    faults.add(at, "runs from right to left, from " + show(line.front().x) + " m to " +
                       show(line.back().x) + " m: give its points the other way round");
    return false;
  }
  if (line.size() < 2) {
    faults.add(at, "has " + std::to_string(line.size()) + " points, must have at least 2");
    sound = false;
  }
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool x = faults.finite(at + index(i) + "/0", line[i].x);
    const bool z = faults.finite(at + index(i) + "/1", line[i].z);
    sound = sound && x && z;
    if (i > 0 && x && line[i].x < line[i - 1].x) {
      faults.add(at + index(i) + "/0", "is " + show(line[i].x) +
                                           " m, must not lie left of the point before it (" +
                                           show(line[i - 1].x) + " m)");
      sound = false;
    }
  }
  return sound;
}

void check_bottom(const Layer& layer, bool last, const std::string& at, FaultList& faults) {
  const int given = int(layer.thickness_m.has_value()) + int(layer.bottom_m.has_value()) +
                    int(layer.bottom_below_toe_m.has_value()) + int(!layer.bottom.empty());
  if (last && given > 0) {
    faults.add(at, "is the last layer and reaches the base: leave its bottom out");
  } else if (!last && given == 0) {
    faults.add(at,
               "has no bottom: only the last layer reaches the base, the others end at one of "
               "thickness_m, bottom_m, bottom, bottom_below_toe_m");
  } else if (given > 1) {
    faults.add(at,
               "has more than one bottom: give one of thickness_m, bottom_m, bottom, "
               "bottom_below_toe_m");
  }
  if (layer.thickness_m) faults.positive(at + "/thickness_m", *layer.thickness_m, "m");
  if (layer.bottom_m) faults.finite(at + "/bottom_m", *layer.bottom_m);
  if (layer.bottom_below_toe_m) {
    faults.finite(at + "/bottom_below_toe_m", *layer.bottom_below_toe_m);
  }
  if (!layer.bottom.empty()) check_line(layer.bottom, at + "/bottom", faults);
}

/// A layer that thins out against the ground or against a layer measured another way is
/// ordinary geology. Bottoms stated in the same way contradict each other when they cross.
void check_same_kind(const Layer& upper, const Layer& lower, const std::string& upper_at,
                     const std::string& at, FaultList& faults) {
  const auto deeper = [&](const char* key, const auto& above, const auto& below) {
    if (above && below && *below <= *above) {
      faults.add(at + key, "is " + show(*below) + " m, must be greater than that of " + upper_at +
                               " above it (" + show(*above) + " m): the layers cross");
    }
  };
  deeper("/thickness_m", upper.thickness_m, lower.thickness_m);
  deeper("/bottom_below_toe_m", upper.bottom_below_toe_m, lower.bottom_below_toe_m);
  if (upper.bottom_m && lower.bottom_m && *lower.bottom_m >= *upper.bottom_m) {
    faults.add(at + "/bottom_m", "is " + show(*lower.bottom_m) + " m, must be below that of " +
                                     upper_at + " above it (" + show(*upper.bottom_m) +
                                     " m): the layers cross");
  }
}

/// Where one of two elevations is a line, the lower must not rise above the upper.
void check_lines_cross(const Layer& upper, const Layer& lower, const std::string& upper_at,
                       const std::string& at, FaultList& faults) {
  const auto sound = [](const Layer& l) { return !l.bottom.empty() && !first_fault(l.bottom); };
  const bool upper_line = sound(upper);
  const bool lower_line = sound(lower);
  if (!(upper_line || upper.bottom_m) || !(lower_line || lower.bottom_m)) return;
  std::vector<double> places;
  for (const Layer* layer : {&upper, &lower}) {
    for (const Point& p : layer->bottom) places.push_back(p.x);
  }
  for (const double x : places) {
    const double above = upper_line ? elevation_at(upper.bottom, x) : *upper.bottom_m;
    const double below = lower_line ? elevation_at(lower.bottom, x) : *lower.bottom_m;
    if (!(below > above)) continue;
    faults.add(at + (lower_line ? "/bottom" : "/bottom_m"),
               "lies at " + show(below) + " m at x = " + show(x) + " m, above the bottom of " +
                   upper_at + " (" + show(above) + " m): the layers cross");
    return;
  }
}

void check_order(const std::vector<Layer>& layers, const std::string& at, FaultList& faults) {
  // Each layer against the nearest one above that is measured in the same way.
  const auto kind = [](const Layer& l) {
    return l.thickness_m ? 1 : l.bottom_below_toe_m ? 2 : (l.bottom_m || !l.bottom.empty()) ? 3 : 0;
  };
  for (std::size_t j = 1; j < layers.size(); ++j) {
    const int wanted = kind(layers[j]);
    if (wanted == 0) continue;
    for (std::size_t i = j; i-- > 0;) {
      if (kind(layers[i]) != wanted) continue;
      const std::string upper_at = at + index(i), lower_at = at + index(j);
      check_same_kind(layers[i], layers[j], upper_at, lower_at, faults);
      check_lines_cross(layers[i], layers[j], upper_at, lower_at, faults);
      break;
    }
  }
}

/// Columns stand side by side: each begins where the one before it ends.
void check_borders(const std::vector<SoilColumn>& columns, FaultList& faults) {
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const std::string at = "/columns" + index(i);
    const double from = columns[i].from_m, to = columns[i].to_m;
    const bool both = faults.finite(at + "/from_m", from) && faults.finite(at + "/to_m", to);
    if (both && !(to > from)) {
      faults.add(at + "/to_m",
                 "is " + show(to) + " m, must be greater than from_m (" + show(from) + " m)");
    }
    if (i == 0 || !both || !std::isfinite(columns[i - 1].to_m)) continue;
    const double end = columns[i - 1].to_m;
    if (from == end) continue;
    faults.add(at + "/from_m", "is " + show(from) + " m, must be " + show(end) +
                                   " m, where the column before it ends: they " +
                                   (from < end ? "overlap" : "leave a gap"));
  }
}

void check_ends(const Section& section, FaultList& faults) {
  const double left = section.ground.front().x, right = section.ground.back().x;
  const SoilColumn& first = section.columns.front();
  const SoilColumn& last = section.columns.back();
  if (first.from_m > left) {
    faults.add("/columns/0/from_m", "is " + show(first.from_m) + " m, must be at most " +
                                        show(left) + " m, where the ground begins");
  }
  if (last.to_m < right) {
    faults.add("/columns" + index(section.columns.size() - 1) + "/to_m",
               "is " + show(last.to_m) + " m, must be at least " + show(right) +
                   " m, where the ground ends");
  }
}

void check_on_ground(const Section& section, Point p, const std::string& at, FaultList& faults) {
  if (!faults.finite(at + "/0", p.x) || !faults.finite(at + "/1", p.z)) return;
  if (p.x < section.ground.front().x || p.x > section.ground.back().x) {
    faults.add(at + "/0", "is " + show(p.x) + " m, must lie on the ground between " +
                              show(section.ground.front().x) + " and " +
                              show(section.ground.back().x) + " m");
    return;
  }
  double lowest = INFINITY;
  for (const Point& g : section.ground) {
    if (g.x == p.x) lowest = std::min(lowest, g.z);
  }
  const double highest = elevation_at(section.ground, p.x);
  lowest = std::min(lowest, highest);
  if (p.z > highest + on_ground || p.z < lowest - on_ground) {
    faults.add(at + "/1", "is " + show(p.z) + " m, must lie on the ground, which is at " +
                              show(highest) + " m at x = " + show(p.x) + " m");
  }
}

}  // namespace

bool check_ground(const Section& section, FaultList& faults) {
  const bool line = check_line(section.ground, "/ground", faults);
  const bool base = faults.finite("/base_m", section.base_m);
  if (!line || !base) return false;
  const Point lowest = std::ranges::min(section.ground, {}, &Point::z);
  if (section.base_m >= lowest.z) {
    faults.add("/base_m", "is " + show(section.base_m) + " m, must lie below the lowest ground (" +
                              show(lowest.z) + " m at x = " + show(lowest.x) + " m)");
    return false;
  }
  return true;
}

std::string layers_pointer(const Section& section, std::size_t list) {
  return section.columns.empty() ? "/layers" : "/columns" + index(list) + "/layers";
}

void check_layers(const std::vector<Layer>& layers,
                  const std::map<std::string, Material>& materials, const std::string& at,
                  FaultList& faults) {
  if (layers.empty()) faults.add(at, "is empty, needs at least one layer that reaches the base");
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const std::string layer_at = at + index(i);
    check_bottom(layers[i], i + 1 == layers.size(), layer_at, faults);
    if (materials.contains(layers[i].material)) continue;
    std::string known;
    for (const auto& [name, material] : materials) {
      known += (known.empty() ? "" : ", ") + ("\"" + name + "\"");
    }
    faults.add(layer_at + "/material", "is \"" + layers[i].material +
                                           "\", which is not defined in " + "/materials" +
                                           (known.empty() ? "" : " (" + known + ")"));
  }
  check_order(layers, at, faults);
}

void check_soil(const Section& section, bool ground_is_sound, FaultList& faults) {
  for (std::size_t list = 0; list < layer_lists(section); ++list) {
    check_layers(layers_of(section, list), section.materials, layers_pointer(section, list),
                 faults);
  }
  if (section.columns.empty()) return;
  check_borders(section.columns, faults);
  if (ground_is_sound) check_ends(section, faults);
}

void check_water_table(const Section& section, FaultList& faults) {
  if (!section.water_table) return;
  const WaterTable& water = *section.water_table;
  if (water.depth_m.has_value() == !water.line.empty()) {
    faults.add("/water_table", "must have exactly one of depth_m and line");
  }
  if (water.depth_m) {
    faults.within("/water_table/depth_m", *water.depth_m, *water.depth_m >= 0,
                  "at least 0 m: standing water is not modelled");
  }
  if (water.line.empty() || !check_line(water.line, "/water_table/line", faults)) return;
  std::vector<double> places;
  for (const Point& p : section.ground) places.push_back(p.x);
  for (const Point& p : water.line) {
    if (p.x >= section.ground.front().x && p.x <= section.ground.back().x) places.push_back(p.x);
  }
  for (const double x : places) {
    const double level = elevation_at(water.line, x);
    const double ground = elevation_at(section.ground, x);
    if (level <= ground + on_ground) continue;
    faults.add("/water_table/line", "lies at " + show(level) + " m at x = " + show(x) +
                                        " m, above the ground (" + show(ground) +
                                        " m): standing water is not modelled");
    return;
  }
}

std::optional<CrestAndToe> check_bank(const Section& section, FaultList& faults) {
  if (section.crest) check_on_ground(section, *section.crest, "/crest_m", faults);
  if (section.toe) check_on_ground(section, *section.toe, "/toe_m", faults);
  std::optional<CrestAndToe> bank;
  if (section.crest && section.toe) {
    bank = CrestAndToe{*section.crest, *section.toe};
  } else {
    bank = find_crest_and_toe(section.ground);
    if (!bank) {
      faults.add("/ground",
                 "has no bank of at least 2 m: give crest_m and toe_m by hand, or another ground");
      return std::nullopt;
    }
    if (section.crest) bank->crest = *section.crest;
    if (section.toe) bank->toe = *section.toe;
  }
  if (!(bank->crest.z > bank->toe.z)) {
    faults.add(section.crest ? "/crest_m" : "/toe_m", "the crest (" + show(bank->crest.z) +
                                                          " m) must lie above the toe (" +
                                                          show(bank->toe.z) + " m)");
    return std::nullopt;
  }
  return bank;
}

}  // namespace leda
