#include "solver/statics/freedoms.hpp"

namespace leda::solver {

namespace {

Freedom image_of(const Freedom& inside, double parity) {
  return {inside.number, parity * inside.sign};
}

// Normal to a side the motion is odd, along it even; at the base both are odd.
void mirror_images(const Grid<double>& grid, Freedoms& freedoms) {
  const std::size_t last = grid.columns - 1;
  for (std::size_t k = 2; k < grid.rows; ++k) {
    freedoms.at(0, k)[0] = image_of(freedoms.at(2, k)[0], -1);
    freedoms.at(0, k)[1] = image_of(freedoms.at(2, k)[1], 1);
    freedoms.at(last, k)[0] = image_of(freedoms.at(last - 2, k)[0], -1);
    freedoms.at(last, k)[1] = image_of(freedoms.at(last - 2, k)[1], 1);
  }
  for (std::size_t i = 0; i < grid.columns; ++i) {
    freedoms.at(i, 0)[0] = image_of(freedoms.at(i, 2)[0], -1);
    freedoms.at(i, 0)[1] = image_of(freedoms.at(i, 2)[1], -1);
  }
}

}  // namespace

Freedoms number_freedoms(Grid<double>& grid) {
  Freedoms freedoms;
  freedoms.rows = grid.rows;
  freedoms.of.resize(grid.columns * grid.rows * 2);
  freedoms.first.assign(grid.columns + 1, 0);
  const double least = least_mass(grid.h);
  std::int32_t next = 0;
  for (std::size_t i = 1; i + 1 < grid.columns; ++i) {
    freedoms.first[i] = next;
    const bool edge = i == 1 || i + 2 == grid.columns;
    for (std::size_t k = 2; k < grid.top[i]; ++k) {
      if (*grid.mass_at(i, k) <= least) continue;
      Freedom* axes = freedoms.at(i, k);
      if (!edge) axes[0] = {next++, 1};
      axes[1] = {next++, 1};
      freedoms.row_of.resize(static_cast<std::size_t>(next), static_cast<std::int32_t>(k));
    }
  }
  freedoms.first[grid.columns - 1] = freedoms.first[grid.columns] = next;
  mirror_images(grid, freedoms);
  return freedoms;
}

void set_displacement(const Freedoms& freedoms, const double* displacement, Grid<double>& grid) {
  for (std::size_t i = 0; i < grid.columns; ++i) {
    double* axis[2] = {grid.velocity_at(i, 0), grid.velocity_at(i, 0) + grid.stride};
    for (std::size_t k = 0; k < grid.top[i]; ++k) {
      for (std::size_t a = 0; a < 2; ++a) {
        const Freedom& freedom = freedoms.at(i, k)[a];
        axis[a][k] = freedom.number < 0 ? 0.0 : freedom.sign * displacement[freedom.number];
      }
    }
  }
}

void gather_force(const Freedoms& freedoms, Grid<double>& grid, double* force) {
  for (std::size_t i = 1; i + 1 < grid.columns; ++i) {
    const double *x = grid.force_at(i, 0), *z = x + grid.stride;
    for (std::size_t k = 2; k < grid.top[i]; ++k) {
      const Freedom* axes = freedoms.at(i, k);
      if (axes[0].number >= 0) force[axes[0].number] = x[k];
      if (axes[1].number >= 0) force[axes[1].number] = z[k];
    }
  }
}

}  // namespace leda::solver
