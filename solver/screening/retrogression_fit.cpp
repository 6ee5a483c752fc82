#include "solver/screening/retrogression_fit.hpp"

#include <array>
#include <cmath>

#include "solver/screening/remolding_energy.hpp"
#include "solver/screening/slide_energy.hpp"

namespace leda::solver {
namespace {

struct CalibrationSite {
  const char* name;
  double unit_weight_kN, liquidity_index, height_m;  // Table 3-3
  double peak_kPa, remolded_kPa, peak_strain;        // Table 3-3
  double alpha, beta, residual_strain;               // Table 3-4, beta per unit strain
  double retrogression_m;                            // Table 3-6, observed
};

/// The five sites that the thesis fits eq. 3-21 to (3.5.2).
constexpr std::array<CalibrationSite, 5> sites{{
    {"Casselman", 17, 2, 44, 87.0, 1.50, 0.065, 1.157, 2.4, 2.50, 450},
    {"Saint-Barnabe-Nord", 16, 1.1, 70, 79.5, 1.59, 0.040, 1.091, 2.6, 2.30, 180},
    {"Saint-Jude", 16.5, 1.2, 30, 55.2, 0.92, 0.032, 1.049, 2.5, 2.40, 80},
    {"Saint-Luc-de-Vincennes", 16, 1.5, 35, 55.0, 1.38, 0.024, 0.945, 2.9, 1.95, 110},
    {"Sainte-Monique", 16, 1, 45, 40.5, 0.74, 0.024, 0.952, 2.8, 1.80, 142},
}};

PostPeakCurve curve_of(const CalibrationSite& s) {
  Site site;
  site.peak_strength_Pa = 1000 * s.peak_kPa;
  site.remolded_strength_Pa = 1000 * s.remolded_kPa;
  site.peak_strain = s.peak_strain;
  site.softening = SiteSoftening{s.alpha, s.beta, s.residual_strain};
  return *post_peak_curve(site);
}

struct Point2 {
  double x = 0, y = 0;
};

/// I_L m against omega = (E_P - E_R) / RD, kPa/m.
std::array<Point2, sites.size()> points(double (*energy)(const PostPeakCurve&)) {
  std::array<Point2, sites.size()> all{};
  for (std::size_t i = 0; i < sites.size(); ++i) {
    const CalibrationSite& s = sites[i];
    const double left = potential_energy(1000 * s.unit_weight_kN, s.height_m) - energy(curve_of(s));
    all[i] = {s.liquidity_index * s.unit_weight_kN, left / 1000 / s.retrogression_m};
  }
  return all;
}

double mean_of(const std::array<Point2, sites.size()>& all, double Point2::*member) {
  double sum = 0;
  for (const Point2& p : all) sum += p.*member;
  return sum / static_cast<double>(all.size());
}

/// Spread and R2 of points about a line.
void measure(const std::array<Point2, sites.size()>& all, OmegaLine& line) {
  const double mean = mean_of(all, &Point2::y);
  double residual = 0;
  double total = 0;
  for (const Point2& p : all) {
    residual += std::pow(p.y - line.intercept - line.slope * p.x, 2);
    total += std::pow(p.y - mean, 2);
  }
  line.spread = std::sqrt(residual / static_cast<double>(all.size() - 2));
  line.r_squared = 1 - residual / total;
}

}  // namespace

OmegaLine omega_thesis() {
  OmegaLine line{4.2, -0.1, 0, 0};
  measure(points(remolding_energy_thesis_reading), line);
  return line;
}

OmegaLine omega_corrected() {
  const auto all = points(remolding_energy);
  const double x = mean_of(all, &Point2::x);
  const double y = mean_of(all, &Point2::y);
  double xy = 0;
  double xx = 0;
  for (const Point2& p : all) {
    xy += (p.x - x) * (p.y - y);
    xx += (p.x - x) * (p.x - x);
  }
  OmegaLine line{y - xy / xx * x, xy / xx, 0, 0};
  measure(all, line);
  return line;
}

}  // namespace leda::solver
