#include "solver/statics/freedoms.hpp"

namespace leda::solver {

namespace {

constexpr double least_mass = 1e-14;  // of a node full of water, as in grid_update.cpp

Freedom image_of(const Freedom& inside, double parity) {
  return {inside.number, parity * inside.sign};
}

// Normal to a side the motion is odd, along it even; at the base both are odd.
void mirror_images(const Grid& grid, Freedoms& freedoms) {
  const auto at = [&](std::size_t i, std::size_t k) { return &freedoms.of[grid.index(i, k) * 2]; };
  const std::size_t last = grid.columns - 1;
  for (std::size_t k = 2; k < grid.rows; ++k) {
    at(0, k)[0] = image_of(at(2, k)[0], -1);
    at(0, k)[1] = image_of(at(2, k)[1], 1);
    at(last, k)[0] = image_of(at(last - 2, k)[0], -1);
    at(last, k)[1] = image_of(at(last - 2, k)[1], 1);
  }
  for (std::size_t i = 0; i < grid.columns; ++i) {
    at(i, 0)[0] = image_of(at(i, 2)[0], -1);
    at(i, 0)[1] = image_of(at(i, 2)[1], -1);
  }
}

}  // namespace

Freedoms number_freedoms(const Grid& grid) {
  Freedoms freedoms;
  freedoms.of.resize(grid.columns * grid.rows * 2);
  freedoms.first.assign(grid.columns + 1, 0);
  const double least = least_mass * 1000 * grid.h * grid.h;
  std::int32_t next = 0;
  for (std::size_t i = 1; i + 1 < grid.columns; ++i) {
    freedoms.first[i] = next;
    const bool edge = i == 1 || i + 2 == grid.columns;
    for (std::size_t k = 2; k < grid.top[i]; ++k) {
      if (grid.node[grid.index(i, k) * Grid::width] <= least) continue;
      Freedom* axes = &freedoms.of[grid.index(i, k) * 2];
      if (!edge) axes[0] = {next++, 1};
      axes[1] = {next++, 1};
      freedoms.row_of.resize(static_cast<std::size_t>(next), static_cast<std::int32_t>(k));
    }
  }
  freedoms.first[grid.columns - 1] = freedoms.first[grid.columns] = next;
  mirror_images(grid, freedoms);
  return freedoms;
}

void set_displacement(const Freedoms& freedoms, const double* displacement, Grid& grid) {
  for (std::size_t i = 0; i < grid.columns; ++i) {
    for (std::size_t v = grid.index(i, 0) * 2; v < grid.index(i, grid.top[i]) * 2; ++v) {
      const Freedom& freedom = freedoms.of[v];
      grid.velocity[v] = freedom.number < 0 ? 0.0 : freedom.sign * displacement[freedom.number];
    }
  }
}

void gather_force(const Freedoms& freedoms, const Grid& grid, double* force) {
  for (std::size_t i = 1; i + 1 < grid.columns; ++i) {
    for (std::size_t k = 2; k < grid.top[i]; ++k) {
      const std::size_t node = grid.index(i, k);
      for (std::size_t axis = 0; axis < 2; ++axis) {
        const std::int32_t number = freedoms.of[node * 2 + axis].number;
        if (number >= 0) force[number] = grid.node[node * Grid::width + 3 + axis];
      }
    }
  }
}

}  // namespace leda::solver
