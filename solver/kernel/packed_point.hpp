#pragma once
// One point of a pack by itself, on its way to another pack.

#include "solver/kernel/packs.hpp"

namespace leda::solver {

/// What a lane holds, by the tables of points.hpp.
template <class Real>
struct PackedPoint {
  std::array<Real, point_numbers<Real>.size()> number{};
  std::array<Real, motion_numbers<Real>.size()> motion{};
  std::int32_t law = 0, id = -1;
};

/// A point and its home cell.
template <class Real>
struct PointAtHome {
  PackPlace home;
  PackedPoint<Real> point;
};

template <class Real>
PackedPoint<Real> take_point(const Packs<Real>& packs, std::size_t i, std::size_t lane) {
  const Pack<Real>& pack = packs.pack[i];
  PackedPoint<Real> p;
  for (std::size_t n = 0; n < p.number.size(); ++n) {
    p.number[n] = (pack.*point_numbers<Real>[n].lane)[lane];
  }
  for (std::size_t n = 0; packs.moves && n < p.motion.size(); ++n) {
    p.motion[n] = (packs.motion[i].*motion_numbers<Real>[n].lane)[lane];
  }
  p.law = pack.law[lane];
  p.id = pack.id[lane];
  return p;
}

template <class Real>
void put_point(const PackedPoint<Real>& p, Packs<Real>& packs, std::size_t i, std::size_t lane) {
  Pack<Real>& pack = packs.pack[i];
  for (std::size_t n = 0; n < p.number.size(); ++n) {
    (pack.*point_numbers<Real>[n].lane)[lane] = p.number[n];
  }
  for (std::size_t n = 0; packs.moves && n < p.motion.size(); ++n) {
    (packs.motion[i].*motion_numbers<Real>[n].lane)[lane] = p.motion[n];
  }
  pack.law[lane] = p.law;
  pack.id[lane] = p.id;
}

/// What stands in a lane without a point: nothing, in the middle of its cell; `law` is any row of
/// the table.
template <class Real>
PackedPoint<Real> no_point(std::int32_t law) {
  PackedPoint<Real> none;
  none.number[0] = none.number[1] = Real{0.5};
  none.law = law;
  return none;
}

}  // namespace leda::solver
