#pragma once
// The laws of all particles of a run as one table: elastic moduli and softening curve.

#include <cstdint>
#include <string>
#include <vector>

#include "solver/materials/softening_curve.hpp"
#include "solver/section/section.hpp"

namespace leda::solver {

/// Laws of rate and flow, one entry a row. The three rate laws are one formula, with
/// r = max(least, rate / reference):
/// factor = base + log_share ln r + power_share r^exponent.
struct ViscousLaws {
  std::vector<double> base, log_share, power_share, exponent, least, reference;
  std::vector<double> consistency, flow_exponent;  ///< Pa s^n and n; consistency 0: does not flow

  bool empty() const { return base.empty(); }
};

/// One entry a row in every array. A row stands for one material at one peak strength.
struct LawTable {
  std::vector<double> bulk, shear;  ///< K, G, Pa
  std::vector<double> peak;         ///< s_up, Pa
  std::vector<double> floor, amplitude, rate, exp_end, line_start, line_slope, line_end, last;
  std::vector<std::int32_t> softens;   ///< 0 or 1
  std::vector<std::int32_t> material;  ///< index in the section's materials, by name
  ViscousLaws viscous;                 ///< empty where no material has such a law
  double band_m = 0;          ///< thickness of a band that strain is averaged over; 0: it is not
  double stiffest_speed = 0;  ///< largest sqrt((K + 4/3 G) / rho), m/s

  std::size_t rows() const { return peak.size(); }
  SofteningCurve curve(std::size_t row) const;
};

/// Builds the table while particles are seeded.
class LawTableBuilder {
 public:
  LawTableBuilder(const Section& section, double cell_m);
  /// Row for a material at a point; strengths within 0.1 % of the material's largest share a row.
  std::int32_t row(std::size_t material_index, double depth_m, double elevation_m);
  const LawTable& table() const { return table_; }

 private:
  std::int32_t add(std::size_t material_index, double peak);
  void add_viscous(const Material& material);

  double cell_m_;
  bool viscous_ = false;
  std::vector<const Material*> materials_;
  std::vector<std::vector<std::int32_t>> rows_;  ///< [material][strength in 0.1 % steps], -1: none
  LawTable table_;
};

/// Ground of a higher Poisson's ratio locks unless dilation is averaged.
inline constexpr double locking_poisson_ratio = 0.46;

/// Whether strength or stress depends on the rate of shear.
inline bool is_viscous(const Material& m) { return m.rate || m.flow; }

/// Whether a law locks: K / G above that of locking_poisson_ratio.
bool nearly_incompressible(const LawTable& table);

/// The same laws without softening, rate and flow; without yield where `elastic`.
LawTable without_softening(const LawTable& table, bool elastic);

}  // namespace leda::solver
