#include "solver/screening/toe_cut.hpp"

#include <algorithm>

#include "solver/section/toe_cut.hpp"

namespace leda::solver {
namespace {

Polyline mirrored(const Polyline& line) {
  Polyline other(line.rbegin(), line.rend());
  for (Point& p : other) p.x = -p.x;
  return other;
}

Point between(const Point& a, const Point& b, double z) {
  return {a.x + (b.x - a.x) * (z - a.z) / (b.z - a.z), z};
}

/// The pieces of ground between the face and the toe: held to the toe's elevation.
void append_lowered(Polyline& out, const Polyline& ground, std::size_t from, const Point& toe) {
  for (std::size_t i = from; i < ground.size(); ++i) {
    const Point& a = i == from ? out.back() : ground[i - 1];
    const Point& b = ground[i];
    const bool in_front = b.x <= toe.x;
    if (in_front && (a.z > toe.z) != (b.z > toe.z)) out.push_back(between(a, b, toe.z));
    out.push_back({b.x, in_front ? std::min(b.z, toe.z) : b.z});
  }
}

/// The cut for a bank whose toe lies right of its crest.
Polyline cut_rightwards(const Polyline& ground, const Point& crest, const Point& toe,
                        double height) {
  const double top = toe.z + std::min(height, crest.z - toe.z);
  // From the toe up to the first ground that is high enough: the piece that holds the face.
  std::size_t front = ground.size();
  for (std::size_t i = ground.size() - 1; i > 0; --i) {
    if (ground[i - 1].x > toe.x || ground[i - 1].z < top) continue;
    front = i;
    break;
  }
  if (front == ground.size()) return ground;
  const Point& above = ground[front - 1];
  const Point& below = ground[front];
  const Point face = above.z > top && below.z < top ? between(above, below, top) : above;
  Polyline cut(ground.begin(), ground.begin() + static_cast<std::ptrdiff_t>(front));
  cut.push_back(face);
  cut.push_back({face.x, toe.z});
  append_lowered(cut, ground, front, toe);
  const auto repeated = std::unique(cut.begin(), cut.end());
  cut.erase(repeated, cut.end());
  return cut;
}

}  // namespace

std::optional<CrestAndToe> bank_of(const Section& section) { return bank_in_use(section); }

Polyline ground_after_toe_cut(const Polyline& ground, const CrestAndToe& bank, double height_m) {
  if (falls_right(ground, bank)) return cut_rightwards(ground, bank.crest, bank.toe, height_m);
  return mirrored(cut_rightwards(mirrored(ground), {-bank.crest.x, bank.crest.z},
                                 {-bank.toe.x, bank.toe.z}, height_m));
}

}  // namespace leda::solver
