#include "solver/section/geometry.hpp"

#include <algorithm>
#include <cmath>

namespace leda {

double elevation_at(const Polyline& line, double x) {
  // Points at one x form a vertical step: all of them count, so that the higher one wins.
  const auto first = std::lower_bound(line.begin(), line.end(), x,
                                      [](const Point& p, double at) { return p.x < at; });
  if (first == line.end()) return line.back().z;
  if (first->x > x) {
    if (first == line.begin()) return first->z;
    const Point& a = *(first - 1);
    const Point& b = *first;
    return a.z + (b.z - a.z) * ((x - a.x) / (b.x - a.x));
  }
  double highest = first->z;
  for (auto p = first; p != line.end() && p->x == first->x; ++p) highest = std::max(highest, p->z);
  return highest;
}

std::optional<LineFault> first_fault(const Polyline& line) {
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (!std::isfinite(line[i].x) || !std::isfinite(line[i].z)) {
      return LineFault{i, "is not a finite number"};
    }
    if (i > 0 && line[i].x < line[i - 1].x) {
      return LineFault{i, "lies left of the point before it"};
    }
  }
  if (line.size() < 2) return LineFault{line.size(), "is missing: a line has at least two points"};
  return std::nullopt;
}

bool is_inside(const Polyline& polygon, Point p) {
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Point& a = polygon[i];
    const Point& b = polygon[j];
    if ((a.z > p.z) == (b.z > p.z)) continue;
    if (p.x < a.x + (b.x - a.x) * ((p.z - a.z) / (b.z - a.z))) inside = !inside;
  }
  return inside;
}

}  // namespace leda
