#include "tests/solver/oracle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "tests/solver/closest_point.hpp"

namespace leda::solver::test {

namespace {

// Quadratic B-spline and its slope over the distance in cells (Steffen et al. 2008).
double weight(double r) {
  r = std::abs(r);
  if (r < 0.5) return 0.75 - r * r;
  return r < 1.5 ? 0.5 * (1.5 - r) * (1.5 - r) : 0.0;
}
double slope(double r) {
  if (std::abs(r) < 0.5) return -2 * r;
  return std::abs(r) < 1.5 ? (r > 0 ? -1.0 : 1.0) * (1.5 - std::abs(r)) : 0.0;
}

}  // namespace

Oracle::Oracle(Particles particles, const GridSize& size, const LawTable& laws,
               const ModelSettings& settings)
    : particles_(std::move(particles)),
      size_(size),
      laws_(laws),
      settings_(settings),
      nodes_(size.columns * size.rows) {}

// Calls one(node, w, dw/dx, dw/dz, x_i - x_p, z_i - z_p) for the nine nodes that a point sees.
template <class One>
void Oracle::for_nodes(const Particle& p, const One& one) {
  const double h = size_.h;
  const auto [column, row] = cell_of(p);
  for (long i = column; i < column + 3; ++i) {
    for (long k = row; k < row + 3; ++k) {
      const double dx = (static_cast<double>(i) - 1) * h - p.x;
      const double dz = (static_cast<double>(k) - 1) * h - p.z;
      const double wx = weight(dx / h), wz = weight(dz / h);
      one(at(static_cast<std::size_t>(i), static_cast<std::size_t>(k)), wx * wz,
          slope(-dx / h) / h * wz, wx * slope(-dz / h) / h, dx, dz);
    }
  }
}

std::pair<long, long> Oracle::cell_of(const Particle& p) const {
  return {std::lround(std::floor(p.x / size_.h + 0.5)),
          std::lround(std::floor(p.z / size_.h + 0.5))};
}

std::map<std::pair<long, long>, Oracle::Span> Oracle::span_means(
    const std::vector<double>& value) const {
  std::map<std::pair<long, long>, Span> spans;
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    Span& span = spans[cell_of(particles_[i])];
    span.volume += particles_[i].volume;
    span.sum += particles_[i].volume * value[i];
  }
  return spans;
}

void Oracle::to_nodes() {
  std::ranges::fill(nodes_, Node{});
  std::vector<double> mean(particles_.size());
  for (std::size_t i = 0; i < mean.size(); ++i) {
    mean[i] = 0.5 * (particles_[i].sxx + particles_[i].szz);
  }
  const auto spans = span_means(mean);
  for (std::size_t i = 0; i < mean.size(); ++i) {
    const Particle& p = particles_[i];
    const Span& span = spans.at(cell_of(p));
    const double more = settings_.averages ? span.sum / span.volume - mean[i] : 0.0;
    for_nodes(p, [&](Node& n, double w, double gx, double gz, double dx, double dz) {
      n.mass += w * p.mass;
      n.px += w * p.mass * (p.vx + p.cxx * dx + p.cxz * dz);
      n.pz += w * p.mass * (p.vz + p.czx * dx + p.czz * dz);
      n.fx -= p.volume * ((p.sxx + more) * gx + p.sxz * gz);
      n.fz -= p.volume * (p.sxz * gx + (p.szz + more) * gz);
      n.strained += w * p.mass * p.plastic_step;
    });
  }
}

// The edges by images: sides hold the normal motion, the base both.
void Oracle::fold_edges() {
  const std::size_t last = size_.columns - 1;
  for (const auto& [ghost, inside, edge] : {std::array<std::size_t, 3>{0, 2, 1},
                                            std::array<std::size_t, 3>{last, last - 2, last - 1}}) {
    for (std::size_t k = 0; k < size_.rows; ++k) {
      const Node& g = at(ghost, k);
      Node& n = at(inside, k);
      n.mass += g.mass;
      n.px -= g.px;
      n.pz += g.pz;
      n.fx -= g.fx;
      n.fz += g.fz;
      n.strained += g.strained;
      at(edge, k).px = at(edge, k).fx = 0;
    }
  }
  for (std::size_t i = 1; i < last; ++i) {
    const Node& g = at(i, 0);
    Node& n = at(i, 2);
    n.mass += g.mass;
    n.px -= g.px;
    n.pz -= g.pz;
    n.fx -= g.fx;
    n.fz -= g.fz;
    n.strained += g.strained;
    at(i, 1).px = at(i, 1).pz = at(i, 1).fx = at(i, 1).fz = 0;
  }
}

void Oracle::mirror_edges() {
  const std::size_t last = size_.columns - 1;
  for (std::size_t i = 1; i < last; ++i) {
    for (std::size_t k = 1; k < size_.rows; ++k) {
      const double sides = i == 1 || i == last - 1 ? 2 : 1;
      at(i, k).seen = at(i, k).mass * sides * (k == 1 ? 2 : 1);
    }
    at(i, 0).vx = -at(i, 2).vx;
    at(i, 0).vz = -at(i, 2).vz;
    at(i, 0).seen = at(i, 2).seen;
  }
  for (std::size_t k = 0; k < size_.rows; ++k) {
    for (const auto& [ghost, inside] :
         {std::pair(std::size_t{0}, std::size_t{2}), std::pair(last, last - 2)}) {
      at(ghost, k).vx = -at(inside, k).vx;
      at(ghost, k).vz = at(inside, k).vz;
      at(ghost, k).seen = at(inside, k).seen;
    }
  }
}

// One pass of (share, 1 - 2 share, share) along both axes; ghost nodes are images.
void Oracle::smooth(double Node::*value, double share) {
  for (const auto& [di, dk] : {std::pair{0, 1}, std::pair{1, 0}}) {
    std::vector<Node> before = nodes_;
    const auto old = [&](std::size_t i, std::size_t k) {
      return k < size_.rows ? before[i * size_.rows + k].*value : 0.0;
    };
    for (std::size_t i = 1; i + 1 < size_.columns; ++i) {
      for (std::size_t k = 1; k < size_.rows; ++k) {
        const double beside = old(i - di, k - dk) + old(i + di, k + dk);
        at(i, k).*value = (1 - 2 * share) * old(i, k) + share * beside;
      }
      at(i, 0).*value = at(i, 2).*value;
    }
    for (std::size_t k = 0; k < size_.rows; ++k) {
      at(0, k).*value = at(2, k).*value;
      at(size_.columns - 1, k).*value = at(size_.columns - 3, k).*value;
    }
  }
}

// The strain of the step as its average over a band (solver/kernel/band.hpp).
void Oracle::average_band() {
  const double s = laws_.band_m / size_.h / std::sqrt(2 * std::numbers::pi);
  const double rest = std::max(0.0, s * s - 2.0 / 3);
  const double passes = std::ceil(2 * rest);
  const std::size_t last = size_.columns - 1;
  for (std::size_t i = 1; i < last; ++i) {
    const double sides = i == 1 || i == last - 1 ? 2 : 1;
    for (std::size_t k = 1; k < size_.rows; ++k) at(i, k).strained *= sides * (k == 1 ? 2 : 1);
  }
  for (Node& n : nodes_) {
    if (&n < &at(1, 0) || &n >= &at(last, 0)) n.strained = 0;
  }
  smooth(&Node::strained, 0);  // the images
  for (Node& n : nodes_) n.weight = n.seen;
  for (double pass = 0; pass < passes; ++pass) {
    smooth(&Node::strained, rest / 2 / passes);
    smooth(&Node::weight, rest / 2 / passes);
  }
  const double least = 1e-11 * size_.h * size_.h;
  for (Node& n : nodes_) n.strained = n.weight > least ? n.strained / n.weight : 0.0;
}

void Oracle::move_nodes(const StepSettings& s, GridSums& sums) {
  for (Node& n : nodes_) n.fz -= n.mass * s.gravity;
  fold_edges();
  for (std::size_t i = 1; i + 1 < size_.columns; ++i) {
    for (std::size_t k = 1; k < size_.rows; ++k) {
      Node& n = at(i, k);
      if (n.mass <= 1e-11 * size_.h * size_.h) continue;
      for (auto [p, f, v] : {std::tuple(n.px, n.fx, &n.vx), std::tuple(n.pz, n.fz, &n.vz)}) {
        const double before = p / n.mass;
        const double damp = before == 0 ? 0 : -s.damping * std::abs(f) * (before > 0 ? 1 : -1);
        *v = before + (f + damp) * s.dt / n.mass;
        sums.kinetic_before += 0.5 * n.mass * before * before;
        sums.kinetic_after += 0.5 * n.mass * *v * *v;
        sums.damping_work += damp * 0.5 * (before + *v) * s.dt;
      }
    }
  }
  mirror_edges();
  if (laws_.band_m > 0) average_band();
}

double Oracle::strength(const Particle& p, double shear_rate, bool rated) const {
  const auto row = static_cast<std::size_t>(p.law);
  const bool soft = laws_.softens[row] != 0 && p.plastic_strain > 0;
  double s = soft ? solver::strength(laws_.curve(row), p.plastic_strain) : laws_.peak[row];
  const ViscousLaws& v = laws_.viscous;
  if (!rated || v.empty()) return s;
  const auto factor = [&](const RateColumns& of) {
    const double rate = laws_.rate_share * shear_rate;
    const double r = std::max(of.least[row], rate / of.reference[row]);
    const double power = of.power_share[row] * std::pow(r, of.exponent[row]);
    return of.base[row] + of.log_share[row] * std::log(r) + power;
  };
  const double remolded = std::min(v.remolded[row], s);
  return remolded * factor(v.remolded_rate) + (s - remolded) * factor(v.rate);
}

// G x + eta (x / dt)^n = excess by halving; the left side grows with x.
double Oracle::flow_strain(const Particle& p, double excess, double shear, double dt) const {
  const auto row = static_cast<std::size_t>(p.law);
  if (laws_.viscous.empty()) return excess / shear;
  const double eta = laws_.viscous.consistency[row], n = laws_.viscous.flow_exponent[row];
  double low = 0, high = excess / shear;
  for (int i = 0; i < 200; ++i) {
    const double x = 0.5 * (low + high);
    (shear * x + eta * std::pow(x / dt, n) > excess ? high : low) = x;
  }
  return 0.5 * (low + high);
}

// Share of the moduli of thin and strained ground (solver/kernel/softer-inl.hpp).
double Oracle::softer(const Particle& p, double seen) const {
  if (!settings_.softer) return 1;
  const double fill = seen * p.volume / (p.mass * size_.h * size_.h) / 0.8;
  return std::clamp(fill * fill, 0.25, 1.0) * (1 - 0.35 * std::min(p.plastic_strain, 1.0));
}

// Elastic with the Jaumann rate, then back to Tresca's surface in principal stresses.
double Oracle::stress(Particle& p, const double (&e)[3], double spin, double dt, double soft,
                      PointSums& sums) const {
  double opening = 0;
  const auto row = static_cast<std::size_t>(p.law);
  const double g = soft * laws_.shear[row], lame = soft * laws_.bulk[row] - 2.0 / 3.0 * g;
  const double before[3] = {p.sxx, p.szz, p.sxz}, trace = e[0] + e[1];
  const double xx = p.sxx + 2 * spin * p.sxz + lame * trace + 2 * g * e[0];
  const double zz = p.szz - 2 * spin * p.sxz + lame * trace + 2 * g * e[1];
  const double xz = p.sxz + spin * (before[1] - before[0]) + 2 * g * e[2];
  const double centre = 0.5 * (xx + zz), radius = std::hypot(0.5 * (xx - zz), xz);
  // In-plane high, in-plane low, across: sorted, returned, and put back.
  std::array<double, 3> own{centre + radius, centre - radius, p.syy + lame * trace};
  std::array<std::size_t, 3> order{0, 1, 2};
  std::ranges::sort(order, [&](std::size_t a, std::size_t b) { return own[a] > own[b]; });
  const double high = own[order[0]], low = own[order[2]];
  const double m = trace / 3;
  const double rate =
      std::sqrt(2 * ((e[0] - m) * (e[0] - m) + (e[1] - m) * (e[1] - m) + m * m + 2 * e[2] * e[2])) /
      dt;
  const double quasi_static = strength(p, 0, false);
  const double sin = laws_.sin_friction.empty() ? 0.0 : laws_.sin_friction[row];
  const double pore = laws_.pore_pressure.empty() ? 0.0 : laws_.pore_pressure[row];
  const double friction = (0.5 * (high + low) + pore) * sin;
  const double tension = laws_.tension.empty()
                             ? beyond_reach
                             : laws_.tension[row] * quasi_static / laws_.peak[row] - pore;
  const auto is_beyond = [&](double s) {
    return high - low > 2 * (s - friction) || high > tension;
  };
  double s = strength(p, rate, is_beyond(quasi_static));
  std::array<double, 3> next = own;
  if (is_beyond(s)) {
    sums.yields = true;
    const double excess = 0.5 * (high - low) - s;
    if (excess > 0 && sin == 0) s += excess - g * flow_strain(p, excess, g, dt);
    next = closest_point(own, {s, tension, sin, pore}, g, lame);
    double square = 0, mean = 0;
    for (std::size_t i = 0; i < 3; ++i) mean += (own[i] - next[i]) / 3;
    for (std::size_t i = 0; i < 3; ++i) {
      square += (own[i] - next[i] - mean) * (own[i] - next[i] - mean);
    }
    opening = mean / (lame + 2.0 / 3.0 * g);
    p.plastic_step = std::sqrt(0.5 * square) / g;
    if (laws_.band_m == 0) p.plastic_strain += p.plastic_step;
    p.plastic_strain = std::max(p.plastic_strain, 1e-150);
  }
  const double shrink = radius > 0 ? 0.5 * (next[0] - next[1]) / radius : 0.0;
  p.sxx = 0.5 * (next[0] + next[1]) + 0.5 * (xx - zz) * shrink;
  p.szz = 0.5 * (next[0] + next[1]) - 0.5 * (xx - zz) * shrink;
  p.sxz = xz * shrink;
  p.syy = next[2];
  sums.stress_work += p.volume * (0.5 * (before[0] + p.sxx) * e[0] +
                                  0.5 * (before[1] + p.szz) * e[1] + (before[2] + p.sxz) * e[2]);
  return opening;
}

void Oracle::to_points(const StepSettings& s, PointSums& sums) {
  struct Gradient {
    double xx = 0, xz = 0, zx = 0, zz = 0, seen = 0, softening = 0;
  };
  std::vector<Gradient> gradient(particles_.size());
  std::vector<double> dilation(particles_.size());
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    Particle& p = particles_[i];
    Gradient& l = gradient[i];
    p.vx = p.vz = p.cxx = p.cxz = p.czx = p.czz = 0;
    const double c = 4 / (size_.h * size_.h);  // APIC (Jiang et al. 2015)
    for_nodes(p, [&](Node& n, double w, double gx, double gz, double dx, double dz) {
      p.vx += w * n.vx;
      p.vz += w * n.vz;
      p.cxx += c * w * n.vx * dx;
      p.cxz += c * w * n.vx * dz;
      p.czx += c * w * n.vz * dx;
      p.czz += c * w * n.vz * dz;
      l.xx += n.vx * gx;
      l.xz += n.vx * gz;
      l.zx += n.vz * gx;
      l.zz += n.vz * gz;
      l.seen += w * n.seen;
      l.softening += w * n.strained;
    });
    dilation[i] = l.xx + l.zz;
  }
  const auto spans = span_means(dilation);
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    Particle& p = particles_[i];
    const Gradient& l = gradient[i];
    const Span& span = spans.at(cell_of(p));
    const double more = settings_.averages ? 0.5 * (span.sum / span.volume - dilation[i]) : 0.0;
    const double e[3] = {s.dt * (l.xx + more), s.dt * (l.zz + more), 0.5 * s.dt * (l.xz + l.zx)};
    p.plastic_step = 0;
    if (laws_.band_m > 0 && p.plastic_strain > 0) p.plastic_strain += l.softening;
    const double opening = stress(p, e, 0.5 * s.dt * (l.xz - l.zx), s.dt, softer(p, l.seen), sums);
    sums.momentum_x += p.mass * p.vx;
    sums.momentum_z += p.mass * p.vz;
    sums.fastest_squared = std::max(sums.fastest_squared, p.vx * p.vx + p.vz * p.vz);
    if (!s.move) continue;
    p.volume *= 1 + e[0] + e[1] - opening;
  }
  for (Particle& p : particles_) {
    if (!s.move) break;
    p.x += s.dt * p.vx;
    p.z += s.dt * p.vz;
  }
}

StepSums Oracle::step(const StepSettings& settings) {
  StepSums sums;
  to_nodes();
  move_nodes(settings, sums.grid);
  to_points(settings, sums.points);
  return sums;
}

}  // namespace leda::solver::test
