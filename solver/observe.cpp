#include "solver/observe.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace leda::solver {

namespace {

std::size_t column_of(const Surface& s, double x) {
  const double at = std::floor((x - s.first_x) / s.cell);
  return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(s.z.size() - 1)));
}

// The column farthest behind the crest whose top dropped, as the x of its far edge.
double backscarp_x(const Surface& before, const Surface& now, double crest_x, bool bank_left) {
  const std::size_t crest = column_of(before, crest_x);
  const std::size_t n = before.z.size();
  const std::size_t count = bank_left ? crest + 1 : n - crest;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t c = bank_left ? i : n - 1 - i;
    if (before.z[c] - now.z[c] > drop_threshold_m) {
      return bank_left ? std::min(before.left(c), crest_x)
                       : std::max(before.left(c) + before.cell, crest_x);
    }
  }
  return crest_x;
}

// Ground of the bank that now lies on top of ground it was not above, as columns beyond the toe.
std::vector<double> debris_reach(const Seeded& seeded, const Section& section, double toe_x,
                                 const Surface& before, bool bank_left) {
  std::vector<double> reach(before.z.size(), 0.0);  // distance past the toe, 0: none
  const Particles& p = seeded.particles;
  for (std::size_t i = 0; i < p.count; ++i) {
    const double x = p.x[i] + seeded.origin_x, start = p.start_x[i] + seeded.origin_x;
    const double past = bank_left ? x - toe_x : toe_x - x;
    const bool from_bank = bank_left ? start < toe_x : start > toe_x;
    if (!from_bank || past <= 0) continue;
    if (p.z[i] + seeded.origin_z <= elevation_at(section.ground, x)) continue;
    double& r = reach[column_of(before, x)];
    r = std::max(r, past);
  }
  return reach;
}

// Distance to the front of the debris that is connected with the toe, column by column.
double connected_front(const std::vector<double>& reach, std::size_t toe, bool bank_left) {
  double front = 0;
  for (std::size_t i = toe; i < reach.size(); bank_left ? ++i : --i) {
    if (reach[i] > front) {
      front = reach[i];
    } else if (i != toe) {
      break;
    }
  }
  return front;
}

}  // namespace

Surface surface(const Seeded& seeded) {
  Surface s;
  s.first_x = seeded.origin_x;
  s.cell = seeded.grid.h;
  s.z.assign(seeded.grid.columns - 3, seeded.origin_z);
  const Particles& p = seeded.particles;
  for (std::size_t i = 0; i < p.count; ++i) {
    double& top = s.z[column_of(s, p.x[i] + seeded.origin_x)];
    top = std::max(top, p.z[i] + seeded.origin_z + 0.5 * seeded.spacing);
  }
  return s;
}

Movement measure(const Seeded& seeded, const Section& section, const CrestAndToe& bank,
                 const Surface& before) {
  const bool bank_left = bank.crest.x < bank.toe.x;
  const Surface now = surface(seeded);
  Movement m;
  const double scarp = backscarp_x(before, now, bank.crest.x, bank_left);
  m.retrogression_m = std::abs(scarp - bank.crest.x);
  m.backscarp = {scarp, elevation_at(section.ground, scarp)};
  const auto reach = debris_reach(seeded, section, bank.toe.x, before, bank_left);
  const double front = connected_front(reach, column_of(before, bank.toe.x), bank_left);
  m.runout_m = front > before.cell ? front : 0.0;  // less than a cell is not resolved
  const double front_x = bank.toe.x + (bank_left ? m.runout_m : -m.runout_m);
  m.front = {front_x, m.runout_m > 0 ? now.z[column_of(now, front_x)] : bank.toe.z};
  return m;
}

void SlideCount::observe(double time_s, double retrogression_m) {
  recent_.push_back({time_s, retrogression_m});
  // The last look before the window is kept: growth is measured over at least its length.
  while (recent_.size() > 2 && recent_[1][0] <= time_s - slide_window_s) recent_.pop_front();
  const double growth = retrogression_m - recent_.front()[1];
  if (!sliding_ && growth >= slide_begins_m) {
    sliding_ = true;
    ++count_;
  } else if (sliding_ && growth < slide_ends_m) {
    sliding_ = false;
  }
}

Frame frame(const Seeded& seeded, const LawTable& laws, double time_s) {
  const Particles& p = seeded.particles;
  std::vector<std::size_t> order(p.count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return p.id[a] < p.id[b]; });
  Frame f;
  f.time_s = time_s;
  const auto put = [](std::vector<float>& to, double value) {
    to.push_back(static_cast<float>(value));
  };
  for (const std::size_t i : order) {
    put(f.x, p.x[i] + seeded.origin_x);
    put(f.z, p.z[i] + seeded.origin_z);
    put(f.velocity_x, p.vx[i]);
    put(f.velocity_z, p.vz[i]);
    put(f.stress_xx, p.sxx[i]);
    put(f.stress_zz, p.szz[i]);
    put(f.stress_xz, p.sxz[i]);
    put(f.stress_yy, p.syy[i]);
    put(f.plastic_strain, p.plastic_strain[i]);
    const auto row = static_cast<std::size_t>(p.law[i]);
    const bool soft = laws.softens[row] != 0 && p.plastic_strain[i] > 0;
    put(f.strength, soft ? strength(laws.curve(row), p.plastic_strain[i]) : laws.peak[row]);
    put(f.volume, p.volume[i]);
    f.material.push_back(laws.material[row]);
  }
  return f;
}

}  // namespace leda::solver
