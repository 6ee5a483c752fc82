#pragma once
// A body force that is not the weight, for problems that are driven by one.

#include "solver/kernel/model.hpp"

namespace leda::solver::test {

/// Adds to the velocity of every point what the force gives it in a step, and makes the sums of the
/// nodes anew from it.
/// @param gain velocity gained, m/s, as a pair, by the id of the point
/// @pre the last step kept the motion
template <class Real, class Gain>
void push(Model<Real>& model, const Gain& gain) {
  for_each_point(model.packs, [&](std::size_t i, std::size_t l) {
    const auto [vx, vz] = gain(static_cast<std::size_t>(model.packs.pack[i].id[l]));
    PackMotion<Real>& motion = model.packs.motion[i];
    motion.vx[l] = static_cast<Real>(static_cast<double>(motion.vx[l]) + vx);
    motion.vz[l] = static_cast<Real>(static_cast<double>(motion.vz[l]) + vz);
  });
  spread_anew(model);
}

}  // namespace leda::solver::test
