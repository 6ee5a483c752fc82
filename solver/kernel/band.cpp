#include "solver/kernel/band.hpp"

#include <algorithm>

namespace leda::solver {

namespace {

// Groups whose nodes the plastic strain of the last step reaches. A point gives to two columns
// beyond its own and one more where it has strayed; a pass carries that on by a column, and brings
// the like of the masses there.
template <class Real>
std::vector<std::uint8_t> reached(const Model<Real>& model) {
  const std::size_t groups = model.yielded.size();
  const std::size_t reach = 1 + (2 * model.grid.band.passes + 4) / columns_of_a_group;
  std::vector<std::uint8_t> is(groups, 0);
  for (std::size_t g = 0; g < groups; ++g) {
    if (model.yielded[g] == 0) continue;
    const std::size_t first = g - std::min(g, reach), last = std::min(g + reach, groups - 1);
    std::fill(is.begin() + static_cast<std::ptrdiff_t>(first),
              is.begin() + static_cast<std::ptrdiff_t>(last) + 1, std::uint8_t{1});
  }
  return is;
}

template <class Real>
void clear(Grid<Real>& grid, std::size_t first, std::size_t last) {
  for (auto& of : grid.band.strain) {
    if (!of.empty()) std::fill_n(&of[first * grid.stride], (last - first) * grid.stride, Real{0});
  }
}

}  // namespace

template <class Real>
void average_band(Model<Real>& model, ThreadTeam& team) {
  Grid<Real>& grid = model.grid;
  if (!grid.band.exists()) return;
  const std::vector<std::uint8_t> is = reached(model);
  const auto each = [&](const auto& part) {
    team.run(is.size(), [&](std::size_t g) {
      const std::size_t first = g * columns_of_a_group;
      part(g, first, std::min(first + columns_of_a_group, grid.columns));
    });
  };
  each([&](std::size_t g, std::size_t first, std::size_t last) {
    if (is[g] != 0) return model.kernel->add_up_band(grid, first, last);
    if (grid.band.active[first] != 0) clear(grid, first, last);
  });
  for (std::size_t g = 0; g < is.size(); ++g) {
    const std::size_t first = g * columns_of_a_group;
    std::fill_n(&grid.band.active[first], std::min(columns_of_a_group, grid.columns - first),
                is[g]);
  }
  for (std::size_t pass = 0; pass < grid.band.passes; ++pass) {
    each([&](std::size_t g, std::size_t first, std::size_t last) {
      if (is[g] != 0) model.kernel->smooth_band(grid, pass, first, last);
    });
  }
}

template void average_band(Model<float>&, ThreadTeam&);
template void average_band(Model<double>&, ThreadTeam&);

}  // namespace leda::solver
