#pragma once
// What a material of a section is: the parameters of every law it uses. SI units (Pa, N/m3).

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "solver/section/random_field.hpp"
#include "solver/section/rate.hpp"

namespace leda {

/// A strength that is constant, or a table over depth below ground or over elevation (thesis 2.6).
struct Strength {
  enum class By { constant, depth, elevation };
  By by = By::constant;
  double constant_Pa = 0;
  std::vector<std::array<double, 2>> table;  ///< rows {depth or elevation in m, strength in Pa}

  double at(double depth_m, double elevation_m) const;
  double smallest() const;
  double largest() const;
};

/// How a softening law measured on a specimen of reference_size is scaled to a cell.
enum class Regularization {
  beta,         ///< the rate of decay alone, as the thesis does (4.5, 5.4.1)
  whole_curve,  ///< every strain of the curve
  band,         ///< every strain, to a band of its own thickness over which the strain is averaged
  none
};

/// Urmi et al., thesis eqs 3-10 / 4-2 to 4-4: exponential down to the residual strength s_uR at
/// gamma_R, then linear down to the remolded strength s_ur at gamma_r.
struct UrmiSoftening {
  double alpha = 1;
  double beta = 0;             ///< per unit strain, > 0
  double residual_strain = 0;  ///< gamma_R, fraction
  double remolded_strength_Pa = 0;
  std::optional<double> residual_strength_Pa;  ///< s_uR; absent: 0.095 s_up (eq. 4-3)
  std::optional<double> remolded_strain;  ///< gamma_r; absent: 0.13 s_up[kPa] gamma_R (eq. 4-4)
};

/// Einav and Randolph 2005, thesis eqs 2-3, 3-4, 4-1:
/// s_u = s_ur + (s_up - s_ur) exp(-3 gamma / gamma_95).
struct EinavRandolphSoftening {
  double remolded_strength_Pa = 0;
  double strain_95 = 0;  ///< gamma_95, fraction
};

/// Exponential with a shape factor, thesis eq. 2-17 and its third appendix:
/// s_u = s_ur + (s_up - s_ur) exp(-eta gamma).
struct ExponentialSoftening {
  double remolded_strength_Pa = 0;
  double shape_factor = 0;  ///< eta, per unit strain
};

/// Linear, thesis eqs 2-1, 2-11: from s_up at zero to s_ur at the remolded strain.
struct LinearSoftening {
  double remolded_strength_Pa = 0;
  double remolded_strain = 0;  ///< fraction
};

/// Dey et al. 2015, thesis eq. 2-2: Einav-Randolph up to twice the shear displacement delta_95,
/// then linear to a large-displacement strength s_uld at delta_ld, constant beyond.
struct DeySoftening {
  double remolded_strength_Pa = 0;      ///< s_uR of Dey et al.
  double strain_95 = 0;                 ///< delta_95 over the shear band, fraction
  double large_strain = 0;              ///< delta_ld over the shear band, fraction
  double large_strain_strength_Pa = 0;  ///< s_u(ld)
};

using SofteningLaw = std::variant<UrmiSoftening, EinavRandolphSoftening, ExponentialSoftening,
                                  LinearSoftening, DeySoftening>;

struct Softening {
  SofteningLaw law;
  double reference_size_m = 0.014;  ///< height of the specimen the law was measured on
  Regularization regularization = Regularization::beta;
  double band_m = 0;  ///< thickness of a band; of Regularization::band alone
};

/// The largest cell a band can have, of its thickness (solver/kernel/band.hpp).
inline constexpr double most_cell_of_band = 0.5;

/// Effective-stress strength, of Mohr and Coulomb.
struct DrainedStrength {
  double cohesion_Pa = 0;
  double friction_angle_deg = 0;
};

struct Material {
  double unit_weight = 0;       ///< total, N/m3
  double shear_modulus_Pa = 0;  ///< G
  double poisson_ratio = 0;     ///< undrained, 0 <= nu < 0.5
  Strength peak_strength;       ///< s_up
  double k0 = 0.5;              ///< ratio of effective stresses
  std::optional<DrainedStrength> drained;
  /// Its strength in the simulation is `drained`, over the effective stress that the water table
  /// gives, in place of s_up: sand, a weathered crust.
  bool drains = false;
  std::optional<Softening> softening;  ///< absent: elastic, perfectly plastic
  /// Of the strength above the remolded one; absent: strength does not depend on the rate of shear.
  std::optional<RateLaw> rate;
  std::optional<RateLaw> remolded_rate;       ///< of the remolded strength; absent: none
  std::optional<double> tensile_strength_Pa;  ///< before any softening; absent: no limit of its
                                              ///< own, and 0 of ground that drains
  std::optional<FlowLaw> flow;                ///< absent: no viscous stress beyond yield
  /// s_up varies within the ground, and what a softening law derives from it; strengths that are
  /// given in Pa stay, but are at most the peak of their place. Absent: s_up is as it stands.
  std::optional<RandomField> field;

  /// What is left after all softening: the part of the strength that `rate` does not act on.
  double remolded_strength_Pa() const;
  double youngs_modulus_Pa() const { return 2 * shear_modulus_Pa * (1 + poisson_ratio); }
};

}  // namespace leda
