#pragma once
// Whether a metre of the map is a metre on the ground: the scale of a projection at a place.

#include <array>
#include <memory>
#include <optional>
#include <string>

#include "profiles/map/coordinates.hpp"

namespace leda::profiles {

/// Metres on the ground per metre of the map, along the directions where they are fewest and most.
struct Stretch {
  double least = 1;
  double most = 1;
  /// The greater of the two departures from 1.
  double departure() const;
};

/// Beyond the first a length says so, beyond the second it is refused: slopes, retrogression and
/// areas would be wrong by as much. UTM stays within 0.1 %.
inline constexpr double told_departure = 0.002, most_departure = 0.01;

/// Belongs to the thread that made it.
class GroundScale {
 public:
  explicit GroundScale(int epsg);
  ~GroundScale();
  GroundScale(GroundScale&&) noexcept;
  GroundScale& operator=(GroundScale&&) noexcept;
  GroundScale(const GroundScale&) = delete;
  GroundScale& operator=(const GroundScale&) = delete;

  /// Of directions along the map's axes {x, y}: ground metres per metre of the map.
  std::optional<std::array<double, 2>> along_axes(MapPoint p) const;
  /// Nothing where the projection is not defined.
  std::optional<Stretch> at(MapPoint p) const;
  /// "1 m of the map is 0.69 m on the ground there: reproject ... EPSG:32618"; empty where the
  /// departure is at most `allowed`.
  std::string complaint_at(MapPoint p, double allowed) const;

 private:
  struct Transformation;
  std::shared_ptr<const Transformation> transformation_;
};

}  // namespace leda::profiles
