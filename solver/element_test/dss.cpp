#include "solver/element_test/dss.hpp"

#include <algorithm>
#include <cmath>

#include "solver/element_test/dissipation.hpp"
#include "solver/materials/rate.hpp"

namespace leda::solver {
namespace {

constexpr int samples_of_rise = 20;
constexpr int samples_of_decay = 400;
constexpr int samples_of_line = 50;

/// Plastic strains at which the law is looked at: even in stress along the exponential, even in
/// strain along the line, both sides of the jump at its start.
std::vector<double> sample_law(const SofteningCurve& c, double max_strain) {
  std::vector<double> strains{0};
  const double decay_end = std::min(c.exp_end, max_strain);
  if (decay_end > 0 && c.rate > 0) {
    for (int i = 1; i <= samples_of_decay; ++i) {
      const double left = 1 - (1 - 1e-6) * i / samples_of_decay;
      const double strain = -std::log(left) / c.rate;
      if (strain < decay_end) strains.push_back(strain);
    }
    // From there to the end of the branch little happens, over what may be a long way.
    const double from = strains.back();
    for (int i = 1; i <= samples_of_line; ++i) {
      strains.push_back(from + (decay_end - from) * i / samples_of_line);
    }
  }
  if (max_strain <= c.exp_end) {
    strains.push_back(max_strain);
    return strains;
  }
  strains.push_back(std::nextafter(c.exp_end, c.exp_end + 1));
  const double line_end = std::min(c.line_end, max_strain);
  for (int i = 1; i <= samples_of_line && line_end > c.exp_end; ++i) {
    strains.push_back(c.exp_end + (line_end - c.exp_end) * i / samples_of_line);
  }
  strains.push_back(max_strain);
  return strains;
}

DssPoint between(const DssPoint& a, const DssPoint& b, double strain) {
  const double t = b.strain == a.strain ? 1 : (strain - a.strain) / (b.strain - a.strain);
  return {strain, std::lerp(a.stress_Pa, b.stress_Pa, t),
          std::lerp(a.plastic_strain, b.plastic_strain, t)};
}

/// Keeps a path whose strain never goes back: where it would, the stress drops at a held strain.
class GrowingStrain {
 public:
  explicit GrowingStrain(std::vector<DssPoint>& points) : points_(points) {}

  void add(const DssPoint& next) {
    if (!points_.empty() && next.strain < points_.back().strain) {
      behind_ = next;
      return;
    }
    if (behind_) points_.push_back(between(*behind_, next, points_.back().strain));
    behind_.reset();
    points_.push_back(next);
  }

 private:
  std::vector<DssPoint>& points_;
  std::optional<DssPoint> behind_;
};

/// Ends the last segment at a strain within it.
void cut_at(std::vector<DssPoint>& points, double strain) {
  if (points.size() < 2 || points.back().strain <= strain) return;
  points.back() = between(points[points.size() - 2], points.back(), strain);
}

}  // namespace

SofteningCurve at_rate(const SofteningCurve& law, const Material& material, double rate) {
  const double above = material.rate ? strength_factor(*material.rate, rate) : 1.0;
  const double below =
      material.remolded_rate ? strength_factor(*material.remolded_rate, rate) : 1.0;
  const double viscous = material.flow ? flow_stress(*material.flow, 0, rate) : 0.0;
  SofteningCurve moved = law;
  moved.amplitude *= above;
  for (double* strength : {&moved.peak, &moved.floor, &moved.line_start, &moved.last}) {
    const double remolded = std::min(material.remolded_strength_Pa(), *strength);
    *strength = below * remolded + above * (*strength - remolded) + viscous;
  }
  return moved;
}

double default_max_strain(const SofteningCurve& law, double shear_modulus_Pa) {
  const double plastic = has_end(law) ? law.line_end : law.rate > 0 ? std::log(1e4) / law.rate : 0;
  return std::max(1.05 * plastic, 5 * law.peak / shear_modulus_Pa);
}

SofteningCurve perfectly_plastic(double peak_Pa) {
  return {.peak = peak_Pa,
          .floor = peak_Pa,
          .amplitude = 0,
          .rate = 0,
          .exp_end = 0,
          .line_start = peak_Pa,
          .line_end = 0,
          .last = peak_Pa};
}

DssCurve dss_of_bare_law(const DssElement& element, std::optional<double> max_strain) {
  const SofteningCurve& law = element.law;
  const double g = element.shear_modulus_Pa;
  const double end = max_strain.value_or(default_max_strain(law, g));
  DssCurve curve{.height_m = element.height_m, .points = {}, .snaps_back = steepest_loss(law) > g};
  GrowingStrain path(curve.points);
  const double elastic_end = std::min(end, law.peak / g);
  for (int i = 0; i <= samples_of_rise; ++i) {
    const double strain = elastic_end * i / samples_of_rise;
    path.add({strain, g * strain, 0});
  }
  if (end <= elastic_end) return curve;
  for (const double plastic : sample_law(law, end)) {
    const double stress = strength(law, plastic);
    const DssPoint next{plastic + stress / g, stress, plastic};
    path.add(next);
    if (next.strain >= end) break;
  }
  cut_at(curve.points, end);
  return curve;
}

double stress_at(const DssCurve& curve, double strain) {
  const auto& points = curve.points;
  const auto after = std::upper_bound(points.begin(), points.end(), strain,
                                      [](double s, const DssPoint& p) { return s < p.strain; });
  if (after == points.begin()) return points.front().stress_Pa;
  if (after == points.end()) return points.back().stress_Pa;
  return between(*(after - 1), *after, strain).stress_Pa;
}

double work_per_area(const DssCurve& curve) {
  double area = 0;
  for (std::size_t i = 1; i < curve.points.size(); ++i) {
    const DssPoint& a = curve.points[i - 1];
    const DssPoint& b = curve.points[i];
    area += (a.stress_Pa + b.stress_Pa) / 2 * (b.strain - a.strain);
  }
  return curve.height_m * area;
}

}  // namespace leda::solver
