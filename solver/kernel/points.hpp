#pragma once
// The numbers of a material point: as one point, as a lane of a pack, and the table of both.
// How to add one: solver/adding.md, "A number of each particle".

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace leda::solver {

/// A material point by itself, for seeding, tests and exchange between models. Positions are
/// relative to the grid's origin; SI units, per metre of width; tension positive.
struct Particle {
  double x = 0, z = 0;                        ///< m
  double vx = 0, vz = 0;                      ///< m/s
  double cxx = 0, cxz = 0, czx = 0, czz = 0;  ///< APIC, c_ij = dv_i/dx_j, 1/s
  double sxx = 0, szz = 0, sxz = 0, syy = 0;  ///< Cauchy stress, Pa
  double plastic_step = 0;                    ///< plastic strain of the last step
  double mass = 0;                            ///< kg/m
  double volume = 0;                          ///< m3/m
  double plastic_strain = 0;                  ///< accumulated engineering shear strain
  std::int32_t law = 0;                       ///< row of the law table
  std::int32_t id = 0;                        ///< order of seeding
};

using Particles = std::vector<Particle>;

/// Two material points in each of eight rows of one column of home cells: lane l lives in row
/// `row + l % rows` (drawing: solver/kernel/README.md). The home cell of a point is that of the
/// lowest node it sees, when it was last put there; so the nodes that eight lanes see are runs of
/// memory, nothing is gathered or scattered, and both points of a row share what is read and
/// summed. Lanes without a point have no mass and no volume, and id -1.
template <class Real>
struct alignas(64) Pack {
  static constexpr std::size_t rows = 8;
  static constexpr std::size_t lanes = 2 * rows;

  Real x[lanes], z[lanes];  ///< from the home cell's lower left corner, in cells
  Real sxx[lanes], szz[lanes], sxz[lanes], syy[lanes];
  Real mass[lanes], volume[lanes];
  Real plastic_strain[lanes];
  Real plastic_rest[lanes];  ///< what rounding took from plastic_strain (Kahan)
  std::int32_t law[lanes];
  std::int32_t id[lanes];
};

/// Velocity, its gradient and the plastic strain of the step at the points of a pack: written only
/// in steps after which somebody looks, since the step itself passes them on in registers.
template <class Real>
struct alignas(64) PackMotion {
  Real vx[Pack<Real>::lanes], vz[Pack<Real>::lanes];  ///< m/s
  /// Times the cell, m/s.
  Real cxx[Pack<Real>::lanes], cxz[Pack<Real>::lanes], czx[Pack<Real>::lanes],
      czz[Pack<Real>::lanes];
  Real plastic_step[Pack<Real>::lanes];  ///< where it is averaged over a band, else zero
};

/// One number, in a pack and in a Particle; null where a Particle has none.
template <class Real>
struct PointNumber {
  const char* name;
  Real (Pack<Real>::*lane)[Pack<Real>::lanes];
  double Particle::*value;
};

/// Every number of a pack. Packing, moving to another cell, and what a checkpoint holds follow it.
template <class Real>
inline constexpr std::array<PointNumber<Real>, 10> point_numbers = {{
    {"x", &Pack<Real>::x, &Particle::x},
    {"z", &Pack<Real>::z, &Particle::z},
    {"sxx", &Pack<Real>::sxx, &Particle::sxx},
    {"szz", &Pack<Real>::szz, &Particle::szz},
    {"sxz", &Pack<Real>::sxz, &Particle::sxz},
    {"syy", &Pack<Real>::syy, &Particle::syy},
    {"mass", &Pack<Real>::mass, &Particle::mass},
    {"volume", &Pack<Real>::volume, &Particle::volume},
    {"plastic_strain", &Pack<Real>::plastic_strain, &Particle::plastic_strain},
    {"plastic_rest", &Pack<Real>::plastic_rest, nullptr},
}};
static_assert(sizeof(Pack<float>) ==
              (point_numbers<float>.size() * sizeof(float) + 2 * sizeof(std::int32_t)) *
                  Pack<float>::lanes);

/// One number of the motion.
template <class Real>
struct MotionNumber {
  const char* name;
  Real (PackMotion<Real>::*lane)[Pack<Real>::lanes];
  double Particle::*value;
  bool per_cell;  ///< a gradient: the pack holds it times the cell
};

template <class Real>
inline constexpr std::array<MotionNumber<Real>, 7> motion_numbers = {{
    {"vx", &PackMotion<Real>::vx, &Particle::vx, false},
    {"vz", &PackMotion<Real>::vz, &Particle::vz, false},
    {"cxx", &PackMotion<Real>::cxx, &Particle::cxx, true},
    {"cxz", &PackMotion<Real>::cxz, &Particle::cxz, true},
    {"czx", &PackMotion<Real>::czx, &Particle::czx, true},
    {"czz", &PackMotion<Real>::czz, &Particle::czz, true},
    {"plastic_step", &PackMotion<Real>::plastic_step, &Particle::plastic_step, false},
}};
static_assert(sizeof(PackMotion<float>) ==
              motion_numbers<float>.size() * sizeof(float) * Pack<float>::lanes);

}  // namespace leda::solver
