#include "solver/kernel/particles.hpp"

namespace leda::solver {

std::vector<std::vector<double>*> Particles::arrays() {
  return {&x,       &z,      &vx,   &vz,     &cxx,
          &cxz,     &czx,    &czz,  &sxx,    &szz,
          &sxz,     &syy,    &mass, &volume, &plastic_strain,
          &start_x, &start_z};
}

void Particles::resize(std::size_t n) {
  count = n;
  const std::size_t size = (n + lanes - 1) / lanes * lanes;
  for (auto* array : arrays()) array->resize(size, 0.0);
  law.resize(size, 0);
  id.resize(size, -1);
}

void Particles::reorder(const std::vector<std::int32_t>& order) {
  const auto permute = [&](auto& array) {
    auto sorted = array;
    for (std::size_t i = 0; i < order.size(); ++i) {
      sorted[i] = array[static_cast<std::size_t>(order[i])];
    }
    array.swap(sorted);
  };
  for (auto* array : arrays()) permute(*array);
  permute(law);
  permute(id);
  resize(order.size());
  fill_padding();
}

void Particles::fill_padding() {
  if (count == 0) return;
  for (std::size_t i = count; i < padded(); ++i) {
    for (auto* array : arrays()) (*array)[i] = (*array)[count - 1];
    mass[i] = 0;
    volume[i] = 0;
    law[i] = law[count - 1];
    id[i] = -1;
  }
}

}  // namespace leda::solver
