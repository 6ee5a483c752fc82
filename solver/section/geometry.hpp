#pragma once
// Points and lines in the plane of a section: x along the section, z elevation, both in metres.

#include <optional>
#include <vector>

namespace leda {

struct Point {
  double x = 0;  ///< distance along the section, m
  double z = 0;  ///< elevation, m
  friend bool operator==(const Point&, const Point&) = default;
};

using Polyline = std::vector<Point>;

/// Elevation of a line whose x never decreases; the ends are held beyond them.
/// At a vertical step the higher of the two elevations is returned.
/// @param line at least one point
double elevation_at(const Polyline& line, double x);

/// First fault of a line that must run from left to right: fewer than two points, a value that
/// is not finite, or an x that goes back. Empty when the line is sound.
struct LineFault {
  std::size_t point = 0;
  const char* what = "";
};
std::optional<LineFault> first_fault(const Polyline& line);

/// Even-odd rule; points on the edge may fall on either side.
bool is_inside(const Polyline& polygon, Point p);

}  // namespace leda
