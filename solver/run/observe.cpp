#include "solver/run/observe.hpp"

#include <algorithm>
#include <cmath>

namespace leda::solver {

namespace {

// Calls one(position from the grid's origin, id) for every point.
template <class One>
void for_each_position(const AnyModel& model, const One& one) {
  with_model(model, [&](const auto& m) {
    for_each_point(m.packs, [&](std::size_t i, std::size_t l) {
      one(point_at(m.packs, i, l, m.grid.h), m.packs.pack[i].id[l]);
    });
  });
}

// The column farthest behind the crest whose top dropped, as the x of its far edge.
double backscarp_x(const Surface& before, const Surface& now, double crest_x, bool bank_left) {
  const std::size_t crest = column_of(before, crest_x);
  const std::size_t n = before.z.size();
  const std::size_t count = bank_left ? crest + 1 : n - crest;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t c = bank_left ? i : n - 1 - i;
    if (before.z[c] - now.z[c] > surface_threshold_m) {
      return bank_left ? std::min(before.left(c), crest_x)
                       : std::max(before.left(c) + before.cell, crest_x);
    }
  }
  return crest_x;
}

// Which columns beyond the toe hold debris: ground of the bank that lies on the initial ground, or
// a surface that rose, be it by debris or by ground the debris pushed up. None where no ground of
// the bank has passed the toe: then it was another bank that moved.
std::vector<bool> debris_columns(const AnyModel& model, const Seeded& seeded,
                                 const Section& section, double toe_x, const Surface& before,
                                 const Surface& now, bool bank_left) {
  std::vector<bool> debris(before.z.size(), false);
  bool any_crossed = false;
  for (std::size_t i = 0; i < debris.size(); ++i) {
    debris[i] = now.z[i] - before.z[i] > surface_threshold_m;
  }
  for_each_position(model, [&](PointAt at, std::int32_t id) {
    const double x = at.x + seeded.origin_x;
    const double start = seeded.start_x[static_cast<std::size_t>(id)] + seeded.origin_x;
    const bool crossed = bank_left ? start < toe_x && x > toe_x : start > toe_x && x < toe_x;
    if (crossed && at.z + seeded.origin_z > elevation_at(section.ground, x)) {
      debris[column_of(before, x)] = true;
      any_crossed = true;
    }
  });
  if (!any_crossed) debris.assign(debris.size(), false);
  return debris;
}

// Whether the bank stands left of its toe. Crest and toe of a vertical face have one x: there the
// columns on its two sides tell.
bool stands_left(const CrestAndToe& bank, const Surface& before) {
  if (bank.crest.x != bank.toe.x) return bank.crest.x < bank.toe.x;
  const std::size_t face = column_of(before, bank.crest.x);
  const std::size_t last = before.z.size() - 1;
  return before.z[face - std::min<std::size_t>(face, 1)] > before.z[std::min(face + 1, last)];
}

bool dropped_beyond(const Surface& before, const Surface& now, double toe_x, bool bank_left) {
  for (std::size_t i = 0; i < before.z.size(); ++i) {
    const bool beyond = bank_left ? before.left(i) > toe_x : before.left(i) + before.cell < toe_x;
    if (beyond && before.z[i] - now.z[i] > surface_threshold_m) return true;
  }
  return false;
}

// The far edge of the last column connected with the toe, gaps of up to two columns allowed.
double connected_front(const std::vector<bool>& debris, const Surface& s, double toe_x,
                       bool bank_left) {
  double front = toe_x;
  std::size_t gap = 0;
  for (std::size_t i = column_of(s, toe_x); i < debris.size() && gap <= most_gap_columns;
       bank_left ? ++i : --i) {
    gap = debris[i] ? 0 : gap + 1;
    if (debris[i]) front = bank_left ? s.left(i) + s.cell : s.left(i);
  }
  return front;
}

}  // namespace

std::size_t column_of(const Surface& s, double x) {
  const double at = std::floor((x - s.first_x) / s.cell);
  return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(s.z.size() - 1)));
}

Surface empty_surface(const Seeded& seeded) {
  Surface s;
  s.first_x = seeded.origin_x;
  s.cell = seeded.size.h;
  s.z.assign(seeded.size.columns - 3, seeded.origin_z);
  return s;
}

double retrogression(const Surface& before, const Surface& now, const CrestAndToe& bank) {
  return std::abs(backscarp_x(before, now, bank.crest.x, stands_left(bank, before)) - bank.crest.x);
}

Movement measure(const AnyModel& model, const Seeded& seeded, const Section& section,
                 const CrestAndToe& bank, const Surface& before) {
  const bool bank_left = stands_left(bank, before);
  const Surface now = surface(model, seeded);
  Movement m;
  const double scarp = backscarp_x(before, now, bank.crest.x, bank_left);
  m.retrogression_m = std::abs(scarp - bank.crest.x);
  m.backscarp = {scarp, elevation_at(section.ground, scarp)};
  const auto debris = debris_columns(model, seeded, section, bank.toe.x, before, now, bank_left);
  const double front = connected_front(debris, before, bank.toe.x, bank_left);
  const double past = std::abs(front - bank.toe.x);
  m.runout_m = past > before.cell ? past : 0.0;  // less than a cell is not resolved
  m.far_side_dropped = dropped_beyond(before, now, bank.toe.x, bank_left);
  m.front = bank.toe;
  if (m.runout_m > 0) m.front = {front, elevation_at(section.ground, front)};
  return m;
}

SlideCount::SlideCount(double bank_height_m, double cell_m)
    : window_s_(0.25 * std::sqrt(bank_height_m / gravity)),
      begins_m_(std::max(0.25 * bank_height_m, 3 * cell_m)) {}

void SlideCount::forget_oldest() {
  std::copy(recent_.begin() + 1, recent_.end(), recent_.begin());
  --recent_count_;
}

void SlideCount::observe(double time_s, double retrogression_m) {
  if (recent_count_ == most_recent) forget_oldest();
  recent_[recent_count_++] = {time_s, retrogression_m};
  while (recent_[0][0] < time_s - window_s_) forget_oldest();
  const double growth = retrogression_m - recent_[0][1];
  if (!sliding_ && growth >= begins_m_) {
    sliding_ = true;
    ++count_;
  } else if (sliding_ && growth < 0.5 * begins_m_) {
    sliding_ = false;
  }
}

}  // namespace leda::solver
