#pragma once
// The ground as a path: points by their distance along it, vertical faces included.

#include <vector>

#include "solver/section/geometry.hpp"

namespace leda::solver {

class GroundPath {
 public:
  explicit GroundPath(const Polyline& ground);

  double length() const { return distances_.back(); }
  Point at(double distance) const;

  /// Distances of about `count` points, close together where the relief around them is large,
  /// and of the sharpest corners; rising.
  std::vector<double> stations(std::size_t count) const;

 private:
  std::vector<double> corners(std::size_t most) const;

  Polyline ground_;
  std::vector<double> distances_;
};

}  // namespace leda::solver
