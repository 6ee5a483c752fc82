#pragma once
// The laws of all particles of a run as one table: elastic moduli and softening curve.

#include <cstdint>
#include <string>
#include <vector>

#include "solver/materials/softening_curve.hpp"
#include "solver/section/section.hpp"

namespace leda::solver {

/// One entry a row in every array. A row stands for one material at one peak strength.
struct LawTable {
  std::vector<double> bulk, shear;  ///< K, G, Pa
  std::vector<double> peak;         ///< s_up, Pa
  std::vector<double> floor, amplitude, rate, exp_end, line_start, line_slope, line_end, last;
  std::vector<std::int32_t> softens;   ///< 0 or 1
  std::vector<std::int32_t> material;  ///< index in the section's materials, by name
  double stiffest_speed = 0;           ///< largest sqrt((K + 4/3 G) / rho), m/s

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

  double cell_m_;
  std::vector<const Material*> materials_;
  std::vector<std::vector<std::int32_t>> rows_;  ///< [material][strength in 0.1 % steps], -1: none
  LawTable table_;
};

/// The same laws without their softening; without yield where `elastic`.
LawTable without_softening(const LawTable& table, bool elastic);

}  // namespace leda::solver
