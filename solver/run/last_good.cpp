#include "solver/run/last_good.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace leda::solver {

namespace {

// One list for both ways.
template <class P>
auto arrays_shown(P& p) {
  return std::array{&p.x,   &p.z,   &p.vx,  &p.vz,     &p.sxx,
                    &p.szz, &p.sxz, &p.syy, &p.volume, &p.plastic_strain};
}

}  // namespace

bool LastGood::keep(const Particles& particles, double time_s) {
  const auto arrays = arrays_shown(particles);
  static_assert(arrays.size() == shown);
  for (const auto* array : arrays) {
    // A sum is finite only if every part is, and costs no branch in the loop.
    float sum = 0;
    for (std::size_t i = 0; i < particles.count; ++i) {
      sum += 0.0F * static_cast<float>((*array)[i]);
    }
    if (!std::isfinite(sum)) return false;
  }
  const auto count = static_cast<std::ptrdiff_t>(particles.count);
  for (std::size_t a = 0; a < shown; ++a) {
    values_[a].resize(particles.count);
    std::transform(arrays[a]->begin(), arrays[a]->begin() + count, values_[a].begin(),
                   [](double v) { return static_cast<float>(v); });
  }
  id_.assign(particles.id.begin(), particles.id.begin() + count);
  time_s_ = time_s;
  return true;
}

double LastGood::restore(Particles& particles) const {
  if (empty()) return time_s_;
  const std::int32_t largest = *std::max_element(id_.begin(), id_.end());
  std::vector<std::size_t> place(static_cast<std::size_t>(largest) + 1);
  for (std::size_t k = 0; k < id_.size(); ++k) place[static_cast<std::size_t>(id_[k])] = k;
  const auto arrays = arrays_shown(particles);
  for (std::size_t i = 0; i < particles.count; ++i) {
    const std::size_t k = place[static_cast<std::size_t>(particles.id[i])];
    for (std::size_t a = 0; a < shown; ++a) {
      (*arrays[a])[i] = static_cast<double>(values_[a][k]);
    }
  }
  particles.fill_padding();
  return time_s_;
}

}  // namespace leda::solver
