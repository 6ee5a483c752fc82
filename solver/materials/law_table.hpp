#pragma once
// The laws of all particles of a run as one table: elastic moduli and softening curve.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "solver/materials/softening_curve.hpp"
#include "solver/section/section.hpp"

namespace leda::solver {

/// Rate laws, one entry a row. All three are one formula, with r = max(least, rate / reference):
/// factor = base + log_share ln r + power_share r^exponent.
struct RateColumns {
  std::vector<double> base, log_share, power_share, exponent, least, reference;

  bool depends() const;  ///< a row has such a law
};

/// Laws of rate and flow, one entry a row.
struct ViscousLaws {
  RateColumns rate;              ///< of the strength above the remolded one
  RateColumns remolded_rate;     ///< of the remolded strength
  std::vector<double> remolded;  ///< remolded strength, Pa; 0 of ground that does not soften
  std::vector<double> consistency, flow_exponent;  ///< Pa s^n and n; consistency 0: does not flow

  bool empty() const { return remolded.empty(); }
};

/// One entry a row in every array. A row stands for one material at one peak strength.
struct LawTable {
  std::vector<double> bulk, shear;  ///< K, G, Pa
  std::vector<double> peak;         ///< s_up, Pa
  std::vector<double> floor, amplitude, rate, exp_end, line_start, line_slope, line_end, last;
  std::vector<double> tension;  ///< tensile strength before any softening, Pa; beyond reach: none
  /// Of ground that drains, whose peak is c' cos(phi'); else 0.
  std::vector<double> sin_friction, pore_pressure;  ///< sin(phi'); u, Pa
  std::vector<std::int32_t> softens;                ///< 0 or 1
  std::vector<std::int32_t> material;               ///< index in the section's materials, by name
  ViscousLaws viscous;                              ///< empty where no material has such a law
  double band_m = 0;  ///< thickness of a band that strain is averaged over; 0: it is not
  /// Shear rate that a rate law takes, of the point's own: a slip in one row of cells has the rate
  /// v / cell there, the band that stands for it v / band. 1 without a band.
  double rate_share = 1;
  double stiffest_speed = 0;  ///< largest sqrt((K + 4/3 G) / rho), m/s

  std::size_t rows() const { return peak.size(); }
  SofteningCurve curve(std::size_t row) const;
};

/// Builds the table while particles are seeded.
class LawTableBuilder {
 public:
  LawTableBuilder(const Section& section, double cell_m);
  /// Row for a material at a point; strengths within 0.1 % of the material's largest share a row,
  /// and so do pore pressures within 50 Pa where the ground drains.
  /// @param factor of the random field at the point; with a field a quarter of the standard
  /// deviation of its logarithm shares a row, which adds 0.5 % to that variance
  std::int32_t row(std::size_t material_index, double depth_m, double elevation_m,
                   double pore_pressure = 0, double factor = 1);
  const LawTable& table() const { return table_; }

 private:
  /// Rows of a material with a random field, one a step of strength, upwards: a field takes
  /// neighbours up and down, and only rows near one another are read without a gather.
  struct FieldRows {
    double step = 0;  ///< of the logarithm of the strength
    long lowest = 0, highest = 0;
    std::int32_t first = 0;
  };

  std::int32_t row_of_field(std::size_t material_index, double strength);
  FieldRows add_rows_of_field(std::size_t material_index);
  std::int32_t add(std::size_t material_index, double peak, double pore_pressure);
  void add_viscous(const Material& material, double peak);

  double cell_m_;
  bool viscous_ = false;
  std::vector<const Material*> materials_;
  /// [material][strength, or pore pressure where the ground drains, in steps]
  std::vector<std::map<long, std::int32_t>> rows_;
  std::map<std::size_t, FieldRows> field_rows_;  ///< of materials with a field
  LawTable table_;
};

/// Stress that nothing gets to, Pa: a limit that is none.
inline constexpr double beyond_reach = 1e30;

/// Ground of a higher Poisson's ratio locks unless dilation is averaged.
inline constexpr double locking_poisson_ratio = 0.46;

/// Whether strength or stress depends on the rate of shear.
inline bool is_viscous(const Material& m) { return m.rate || m.remolded_rate || m.flow; }

/// Whether a law locks: K / G above that of locking_poisson_ratio.
bool nearly_incompressible(const LawTable& table);

/// Whether strength depends on the rate in any row.
bool has_rate(const LawTable& table);

/// The same laws, strength being that of the laboratory's rate.
LawTable without_rate(const LawTable& table);

/// The same laws without softening, rate, flow and tensile strength; without yield where `elastic`.
LawTable without_softening(const LawTable& table, bool elastic);

}  // namespace leda::solver
