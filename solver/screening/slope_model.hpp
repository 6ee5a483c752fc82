#pragma once
// A section resolved for limit equilibrium: what stands above a point, and what strength it has.

#include <algorithm>
#include <vector>

#include "solver/screening/limit_equilibrium.hpp"
#include "solver/section/section.hpp"

namespace leda::solver {

/// Walks along a line from left to right: one search to begin with, then constant time a step.
class LineWalker {
 public:
  explicit LineWalker(const Polyline& line) : line_(&line) {}

  /// @pre x is not less than at the last call
  double at(double x) {
    const Polyline& line = *line_;
    if (next_ == 0) {
      const auto from = std::ranges::lower_bound(line, x, {}, &Point::x);
      next_ = static_cast<std::size_t>(from - line.begin());
    }
    while (next_ < line.size() && line[next_].x < x) ++next_;
    if (next_ == 0) return line.front().z;
    if (next_ == line.size()) return line.back().z;
    const Point& a = line[next_ - 1];
    const Point& b = line[next_];
    return a.z + (b.z - a.z) * ((x - a.x) / (b.x - a.x));
  }

 private:
  const Polyline* line_;
  std::size_t next_ = 0;
};

/// One layer with its material's parameters at hand.
struct Stratum {
  enum class Bottom { thickness, elevation, line };
  Bottom kind = Bottom::elevation;
  double value = 0;  ///< thickness or elevation, m
  Polyline line;
  double unit_weight = 0;
  const Strength* undrained = nullptr;  ///< s_up; unused where drained
  bool drains = false;                  ///< strength is the drained one
  double cohesion = 0, tan_phi = 0;
};

/// Layers from an x on, to the next column's.
struct StrataFrom {
  double from = 0;
  std::vector<Stratum> strata;  ///< top down
};

/// Strength parameters where a slip surface passes.
struct Resistance {
  double cohesion = 0;
  double tan_phi = 0;
  double pore_pressure = 0;
};

/// @pre keep `section` alive as long as the model
struct SlopeModel {
  /// @param present the surface as it is; layers, strengths over depth and water keep to the
  /// section's own ground, so that a cut does not move them
  SlopeModel(const Section& section, Polyline present, Drainage drainage);

  Polyline ground;     ///< the surface as it is
  Polyline reference;  ///< the section's own ground
  double base = 0;
  std::vector<StrataFrom> columns;  ///< left to right; the first holds from the left end
  std::size_t most_strata = 0;      ///< of a column
  bool drains = false;              ///< a stratum does
  bool wet = false;
  bool water_follows_ground = false;
  double water_depth = 0;
  Polyline water;
  std::vector<double> steps;  ///< x of vertical faces of the ground and of borders of columns
};

/// The vertical through one x, kept up to date while walking rightwards.
class Column {
 public:
  explicit Column(const SlopeModel& model);

  void move_to(double x);
  double ground() const { return ground_; }
  /// The base where the column has fewer strata.
  double bottom(std::size_t stratum) const { return bottoms_[std::min(stratum, last())]; }
  /// Weight of the ground above z per square metre, Pa.
  double weight_above(double z) const;
  Resistance resistance_at(double z) const;
  /// On the bottom of a stratum: the weaker of the two sides.
  Resistance resistance_on(std::size_t stratum) const;

 private:
  std::size_t last() const { return bottoms_.size() - 1; }
  std::size_t stratum_at(double z) const;
  Resistance resistance_in(std::size_t index, double z) const;

  void enter(std::size_t column);

  const SlopeModel* model_;
  std::size_t column_ = 0;
  LineWalker present_, own_, water_;
  std::vector<LineWalker> lines_;
  std::vector<double> bottoms_;
  double ground_ = 0, own_ground_ = 0, water_level_ = 0;
};

}  // namespace leda::solver
