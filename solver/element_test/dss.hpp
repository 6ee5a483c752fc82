#pragma once
// Direct simple shear of one element: the curve that a test would show.

#include <optional>
#include <vector>

#include "solver/materials/softening_curve.hpp"
#include "solver/section/material.hpp"

namespace leda::solver {

struct DssPoint {
  double strain = 0;          ///< engineering shear strain, elastic and plastic, fraction
  double stress_Pa = 0;       ///< shear stress
  double plastic_strain = 0;  ///< engineering, what the softening law counts
};

/// A test under a strain that only grows. Where the element snaps back, two points share a strain.
struct DssCurve {
  double height_m = 0;  ///< of the specimen or the cell: displacement = strain x height
  std::vector<DssPoint> points;
  bool snaps_back = false;  ///< the law loses strength faster than G unloads
};

/// What is sheared.
struct DssElement {
  double shear_modulus_Pa = 0;
  SofteningCurve law;  ///< already scaled to the height
  double height_m = 0;
};

/// A curve for clay that does not soften: the peak for ever.
SofteningCurve perfectly_plastic(double peak_Pa);

/// 5 % of strain in an hour, as a standard direct simple shear test is run, 1/s.
inline constexpr double standard_shear_rate = 0.05 / 3600;

/// The curve of a test at another engineering shear rate, 1/s: what lies above the remolded
/// strength times the rate law's factor, the remolded strength times its own, plus the viscous
/// stress of the flow law. Elastic strain is left out of the rate, so the steepest part of the
/// curve is an approximation.
SofteningCurve at_rate(const SofteningCurve& law, const Material& material, double rate);

/// Where a test ends by itself: 5 % beyond the strain where the law ends, or where 99.99 % of an
/// endless exponential is spent; at least five times the strain at the peak.
double default_max_strain(const SofteningCurve& law, double shear_modulus_Pa);

/// The bare law: elastic with G up to s_up, then stress = law(plastic strain) and strain = plastic
/// strain + stress / G. No waves, no second stress component: what eq. 4-2 says, exactly.
/// @param max_strain the strain to stop at; absent: default_max_strain()
DssCurve dss_of_bare_law(const DssElement& element, std::optional<double> max_strain = {});

/// Stress of a curve at a strain, straight between points; the lower end of a drop. Pa.
double stress_at(const DssCurve& curve, double strain);

/// Work of the test, energy per area, N/m: height x the area under stress over strain.
double work_per_area(const DssCurve& curve);

}  // namespace leda::solver
