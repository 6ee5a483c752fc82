#pragma once
// One point of a pack by itself.

#include "solver/kernel/packs.hpp"

namespace leda::solver {

/// As in Pack.
struct PackedPoint {
  Real x, z, sxx, szz, sxz, syy, mass, volume, plastic_strain, plastic_rest;
  std::int32_t law, particle;
};

/// A point and its home cell.
struct PointAtHome {
  PackPlace home;
  PackedPoint point;
};

inline PackedPoint point_at(const Pack& p, std::size_t l) {
  return {p.x[l],
          p.z[l],
          p.sxx[l],
          p.szz[l],
          p.sxz[l],
          p.syy[l],
          p.mass[l],
          p.volume[l],
          p.plastic_strain[l],
          p.plastic_rest[l],
          p.law[l],
          p.particle[l]};
}

inline void put_point(const PackedPoint& point, Pack& p, std::size_t l) {
  p.x[l] = point.x;
  p.z[l] = point.z;
  p.sxx[l] = point.sxx;
  p.szz[l] = point.szz;
  p.sxz[l] = point.sxz;
  p.syy[l] = point.syy;
  p.mass[l] = point.mass;
  p.volume[l] = point.volume;
  p.plastic_strain[l] = point.plastic_strain;
  p.plastic_rest[l] = point.plastic_rest;
  p.law[l] = point.law;
  p.particle[l] = point.particle;
}

/// What stands in a lane without a point; `law` is any row of the table.
inline PackedPoint no_point(std::int32_t law) {
  return {Real{0.5}, Real{0.5}, 0, 0, 0, 0, 0, 0, 0, 0, law, -1};
}

}  // namespace leda::solver
