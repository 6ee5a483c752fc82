#include "profiles/zonation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>

#include "disk/sha256.hpp"
#include "profiles/areas.hpp"
#include "profiles/map_geometry.hpp"
#include "solver/section/gathered_warnings.hpp"

namespace leda::profiles {
namespace {

constexpr double least_area_m2 = 0.01;

// The strip of one section in one zone: from its upper to its lower end.
struct Edge {
  MapPoint upper;
  MapPoint lower;
};

Edge edge_of(const PlacedResult& section, ZoneKind kind) {
  return kind == ZoneKind::release ? Edge{section.backscarp, section.toe}
                                   : Edge{section.toe, section.front};
}

MapPoint moved_by(MapPoint p, MapPoint by) { return {p.x + by.x, p.y + by.y}; }
MapPoint middle(MapPoint a, MapPoint b) { return {(a.x + b.x) / 2, (a.y + b.y) / 2}; }
double dot(MapPoint a, MapPoint b) { return a.x * b.x + a.y * b.y; }

// From crest to toe, of length one.
MapPoint downhill(const PlacedResult& s) {
  const MapPoint way{s.toe.x - s.crest.x, s.toe.y - s.crest.y};
  const double length = std::hypot(way.x, way.y);
  return length > 0 ? MapPoint{way.x / length, way.y / length} : MapPoint{0, 0};
}

MapPoint scaled(MapPoint v, double by) { return {v.x * by, v.y * by}; }

// Each warning once, with the sections it is about.
std::vector<std::string> warnings_of(const std::vector<const PlacedResult*>& sections) {
  GatheredWarnings gathered;
  for (const PlacedResult* s : sections) gathered.add(s->section, s->warnings);
  return lines_of(gathered);
}

// A chain of sections joined to one zone of each kind; the rings are what it is made of.
struct Chain {
  std::vector<const PlacedResult*> sections;
  std::map<ZoneKind, std::vector<MapLine>> rings;
  std::vector<std::string> warnings;

  void add_ring(ZoneKind kind, MapLine ring) { rings[kind].push_back(std::move(ring)); }

  void join(const PlacedResult& a, const PlacedResult& b) {
    for (const ZoneKind kind : {ZoneKind::release, ZoneKind::runout}) {
      const Edge ea = edge_of(a, kind), eb = edge_of(b, kind);
      add_ring(kind, {ea.upper, ea.lower, eb.lower, eb.upper, ea.upper});
    }
  }

  // Ends at full length, the section's edge moved by a vector.
  void extend(const PlacedResult& s, MapPoint by) {
    for (const ZoneKind kind : {ZoneKind::release, ZoneKind::runout}) {
      const Edge e = edge_of(s, kind);
      add_ring(kind, {e.upper, e.lower, moved_by(e.lower, by), moved_by(e.upper, by), e.upper});
    }
  }

  // Closes to nothing at a point.
  void close_at(const PlacedResult& s, MapPoint apex) {
    for (const ZoneKind kind : {ZoneKind::release, ZoneKind::runout}) {
      const Edge e = edge_of(s, kind);
      add_ring(kind, {e.upper, e.lower, apex, e.upper});
    }
  }
};

class Zonation {
 public:
  explicit Zonation(const ZonationOptions& options) : options_(options) {}

  void add_line(std::vector<const PlacedResult*> line) {
    std::stable_sort(line.begin(), line.end(), [](const PlacedResult* a, const PlacedResult* b) {
      return a->order < b->order;
    });
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (!line[i]->known || !line[i]->moved) continue;
      Chain chain;
      end_chain(chain, line, i, -1);
      chain.sections.push_back(line[i]);
      while (i + 1 < line.size() && joins(*line[i], *line[i + 1])) {
        chain.join(*line[i], *line[i + 1]);
        chain.sections.push_back(line[++i]);
      }
      end_chain(chain, line, i, +1);
      finish(chain);
    }
  }

  void add_single(const PlacedResult& section) {
    if (!section.known || !section.moved) return;
    Chain chain;
    chain.sections = {&section};
    const MapPoint way = downhill(section);
    const double half = options_.strip_width_m / 2 / options_.metres_per_unit;
    chain.extend(section, {-way.y * half, way.x * half});
    chain.extend(section, {way.y * half, -way.x * half});
    finish(chain);
  }

  std::vector<Zone> zones;

 private:
  static bool joins(const PlacedResult& a, const PlacedResult& b) {
    return a.known && a.moved && b.known && b.moved && dot(downhill(a), downhill(b)) > 0;
  }

  static bool may_move_yet(const PlacedResult& s) {
    return s.retrogression_is == Bound::lower_bound || s.runout_is == Bound::lower_bound;
  }

  // The end of a chain at section i towards the next section (side +1) or the one before (-1).
  void end_chain(Chain& chain, const std::vector<const PlacedResult*>& line, std::size_t i,
                 int side) const {
    const PlacedResult& s = *line[i];
    const bool at_end = side < 0 ? i == 0 : i + 1 == line.size();
    if (at_end) {
      chain.extend(s, along_line(line, i, side, half_spacing(line, i, -side)));
      return;
    }
    const PlacedResult& neighbour = *line[side < 0 ? i - 1 : i + 1];
    if (neighbour.known && !neighbour.moved) {
      chain.close_at(s, middle(s.toe, neighbour.toe));
      if (may_move_yet(neighbour)) {
        chain.warnings.push_back(neighbour.section +
                                 " moved 0 m, which is a lower bound: the zone closes half-way to "
                                 "it and may reach farther");
      }
      return;
    }
    chain.extend(s, along_line(line, i, side, half_spacing(line, i, side)));
    chain.warnings.push_back(
        neighbour.known
            ? neighbour.section + " moves to the other side: the zone ends half-way to it"
            : neighbour.section + " has no result: the zone ends half-way to it");
  }

  // Half the distance to a neighbour in units of the CRS; the width of a strip where there is none.
  double half_spacing(const std::vector<const PlacedResult*>& line, std::size_t i, int side) const {
    const bool none = side < 0 ? i == 0 : i + 1 == line.size();
    const double spacing_m = none
                                 ? options_.strip_width_m
                                 : std::abs(line[side < 0 ? i - 1 : i + 1]->order - line[i]->order);
    return spacing_m / 2 / options_.metres_per_unit;
  }

  // A vector of that length across section i, towards growing (+1) or falling (-1) order.
  static MapPoint along_line(const std::vector<const PlacedResult*>& line, std::size_t i, int side,
                             double length) {
    const MapPoint way = downhill(*line[i]);
    const MapPoint across{-way.y, way.x};
    const PlacedResult& before = *line[i == 0 ? 0 : i - 1];
    const PlacedResult& after = *line[i + 1 == line.size() ? i : i + 1];
    const MapPoint forward{after.toe.x - before.toe.x, after.toe.y - before.toe.y};
    const double sense = dot(across, forward) < 0 ? -1 : 1;
    return scaled(across, sense * side * length);
  }

  void finish(const Chain& chain) {
    for (const auto& [kind, rings] : chain.rings) {
      Zone zone;
      zone.kind = kind;
      const double unit2 = options_.metres_per_unit * options_.metres_per_unit;
      zone.area = union_of(rings, least_area_m2 / unit2);
      if (zone.area.empty()) continue;
      describe(zone, chain);
      zones.push_back(std::move(zone));
    }
  }

  void describe(Zone& zone, const Chain& chain) const {
    const bool release = zone.kind == ZoneKind::release;
    std::string made_of = release ? "release" : "runout";
    made_of += fmt::format("\n{:.17g}\n{:.17g}", options_.metres_per_unit, options_.strip_width_m);
    double sum = 0;
    for (const PlacedResult* s : chain.sections) {
      zone.sections.push_back(s->section);
      const double distance_m = release ? s->retrogression_m : s->runout_m;
      zone.largest_distance_m = std::max(zone.largest_distance_m, distance_m);
      sum += distance_m;
      const Bound is = release ? s->retrogression_is : s->runout_is;
      if (is == Bound::lower_bound) zone.distance_is = is;
      made_of += "\n" + s->section + " " + s->made_by;
    }
    zone.mean_distance_m = sum / static_cast<double>(chain.sections.size());
    zone.warnings = warnings_of(chain.sections);
    zone.warnings.insert(zone.warnings.end(), chain.warnings.begin(), chain.warnings.end());
    for (const MapPolygon& part : zone.area) {
      for (const MapPoint& p : part.outer) made_of += fmt::format("\n{:.6f} {:.6f}", p.x, p.y);
    }
    zone.made_by = disk::sha256_of(made_of);
  }

  const ZonationOptions& options_;
};

}  // namespace

std::vector<Zone> make_zones(const std::vector<PlacedResult>& results,
                             const ZonationOptions& options) {
  std::map<int, std::vector<const PlacedResult*>> lines;
  Zonation zonation(options);
  for (const PlacedResult& section : results) {
    if (section.line < 0) {
      zonation.add_single(section);
    } else {
      lines[section.line].push_back(&section);
    }
  }
  for (auto& [number, line] : lines) zonation.add_line(std::move(line));
  return std::move(zonation.zones);
}

}  // namespace leda::profiles
