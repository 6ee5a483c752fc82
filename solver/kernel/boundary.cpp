#include "solver/kernel/boundary.hpp"

namespace leda::solver {

namespace {

struct Parity {
  double x, z;  ///< 1 even, -1 odd
};
constexpr Parity side{-1, 1};
constexpr Parity base{-1, -1};

void fold(const double* image, double* inside, Parity parity) {
  inside[0] += image[0];
  inside[1] += parity.x * image[1];
  inside[2] += parity.z * image[2];
  inside[3] += parity.x * image[3];
  inside[4] += parity.z * image[4];
}

void fold_side(Grid& grid, std::size_t image, std::size_t edge, std::size_t inside) {
  for (std::size_t k = 0; k < grid.top[image]; ++k) {
    fold(grid.at(image, k), grid.at(inside, k), side);
  }
  for (std::size_t k = 0; k < grid.top[edge]; ++k) {
    double* node = grid.at(edge, k);
    node[1] = 0;
    node[3] = 0;
  }
}

void mirror_side(Grid& grid, std::size_t image, std::size_t inside) {
  for (std::size_t k = 0; k < grid.top[image]; ++k) {
    const double* from = &grid.velocity[grid.index(inside, k) * 2];
    double* to = &grid.velocity[grid.index(image, k) * 2];
    to[0] = side.x * from[0];
    to[1] = side.z * from[1];
  }
}

}  // namespace

void fold_images(Grid& grid) {
  const std::size_t last = grid.columns - 1;
  fold_side(grid, 0, 1, 2);
  fold_side(grid, last, last - 1, last - 2);
  for (std::size_t i = 0; i < grid.columns; ++i) {
    if (grid.top[i] < 3) continue;
    fold(grid.at(i, 0), grid.at(i, 2), base);
    double* node = grid.at(i, 1);
    for (int v = 1; v < 5; ++v) node[v] = 0;
  }
}

void mirror_velocity(Grid& grid) {
  const std::size_t last = grid.columns - 1;
  for (std::size_t i = 0; i < grid.columns; ++i) {
    if (grid.top[i] < 3) continue;
    const double* from = &grid.velocity[grid.index(i, 2) * 2];
    double* to = &grid.velocity[grid.index(i, 0) * 2];
    to[0] = base.x * from[0];
    to[1] = base.z * from[1];
  }
  mirror_side(grid, 0, 2);
  mirror_side(grid, last, last - 2);
}

}  // namespace leda::solver
