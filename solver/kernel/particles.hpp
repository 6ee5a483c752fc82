#pragma once
// The material points of one run, as a structure of arrays.

#include <cstdint>
#include <vector>

namespace leda::solver {

/// Positions are relative to the grid's origin, SI units throughout, tension positive. Arrays are
/// padded with massless particles to a multiple of `lanes`, so that kernels need no remainder.
struct Particles {
  static constexpr std::size_t lanes = 8;

  std::size_t count = 0;  ///< without the padding
  std::vector<double> x, z;
  std::vector<double> vx, vz;
  std::vector<double> cxx, cxz, czx, czz;  ///< velocity gradient (APIC), c_ij = dv_i/dx_j, 1/s
  std::vector<double> sxx, szz, sxz, syy;  ///< Cauchy stress, Pa
  std::vector<double> mass;                ///< kg per metre of width
  std::vector<double> volume;              ///< m3 per metre of width
  std::vector<double> plastic_strain;      ///< accumulated engineering shear strain
  std::vector<double> start_x, start_z;    ///< where the particle was seeded
  std::vector<std::int32_t> law;           ///< row of the law table
  std::vector<std::int32_t> id;            ///< order of seeding

  std::size_t padded() const { return x.size(); }

  /// Every array of numbers, in one fixed order.
  std::vector<std::vector<double>*> arrays();

  /// Sizes every array for n particles plus padding; new entries are zero.
  void resize(std::size_t n);

  /// Puts particle order[i] at place i for the first order.size() places; drops the others.
  void reorder(const std::vector<std::int32_t>& order);

  /// Makes the padding massless copies of the last particle, which any kernel can digest.
  void fill_padding();
};

}  // namespace leda::solver
