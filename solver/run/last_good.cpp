#include "solver/run/last_good.hpp"

#include <algorithm>
#include <cmath>

namespace leda::solver {

namespace {

// What is kept, one list for both ways.
constexpr std::array kept = {
    &Particle::x,   &Particle::z,   &Particle::vx,  &Particle::vz,     &Particle::sxx,
    &Particle::szz, &Particle::sxz, &Particle::syy, &Particle::volume, &Particle::plastic_strain};

// The lane of a pack, or of its motion, that holds a number of a Particle.
template <class Real>
const Real* lanes_of(const Packs<Real>& packs, std::size_t i, double Particle::*value) {
  for (const auto& number : point_numbers<Real>) {
    if (number.value == value) return packs.pack[i].*number.lane;
  }
  for (const auto& number : motion_numbers<Real>) {
    if (number.value == value && packs.moves) return packs.motion[i].*number.lane;
  }
  static constexpr Real still[Pack<Real>::lanes] = {};
  return still;
}

template <class Real>
bool is_finite(const Packs<Real>& packs, std::size_t i) {
  // A sum is finite only if every part is, and costs no branch in the loop.
  float sum = 0;
  for (double Particle::*value : kept) {
    const Real* lanes = lanes_of(packs, i, value);
    for (std::size_t l = 0; l < Pack<Real>::lanes; ++l) sum += 0.0F * static_cast<float>(lanes[l]);
  }
  return std::isfinite(sum);
}

}  // namespace

bool LastGood::keep(const AnyModel& model, double time_s) {
  static_assert(kept.size() == shown);
  return with_model(model, [&](const auto& m) {
    const auto& packs = m.packs;
    for (std::size_t i = 0; i < packs.pack.size(); ++i) {
      if (packs.taken[i] != 0 && !is_finite(packs, i)) return false;
    }
    for (auto& array : values_) array.resize(packs.count);
    id_.resize(packs.count);
    std::size_t k = 0;
    for (std::size_t i = 0; i < packs.pack.size(); ++i) {
      std::array<decltype(lanes_of(packs, i, kept[0])), shown> lanes{};
      for (std::size_t a = 0; a < shown; ++a) lanes[a] = lanes_of(packs, i, kept[a]);
      for (std::size_t l = 0; l < packs.pack[i].lanes; ++l) {
        if ((packs.taken[i] >> l & 1U) == 0) continue;
        const PointAt at = point_at(packs, i, l, m.grid.h);
        values_[0][k] = static_cast<float>(at.x);
        values_[1][k] = static_cast<float>(at.z);
        for (std::size_t a = 2; a < shown; ++a) values_[a][k] = static_cast<float>(lanes[a][l]);
        id_[k++] = packs.pack[i].id[l];
      }
    }
    time_s_ = time_s;
    return true;
  });
}

double LastGood::restore(Particles& particles) const {
  if (empty()) return time_s_;
  std::vector<std::size_t> place(static_cast<std::size_t>(*std::ranges::max_element(id_)) + 1);
  for (std::size_t k = 0; k < id_.size(); ++k) place[static_cast<std::size_t>(id_[k])] = k;
  for (Particle& p : particles) {
    const std::size_t k = place[static_cast<std::size_t>(p.id)];
    for (std::size_t a = 0; a < shown; ++a) p.*kept[a] = static_cast<double>(values_[a][k]);
  }
  return time_s_;
}

}  // namespace leda::solver
