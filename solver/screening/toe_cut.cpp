#include "solver/screening/toe_cut.hpp"

#include <algorithm>

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

/// Index of the first point right of the crest that lies at or below z.
std::size_t first_at_or_below(const Polyline& ground, double crest_x, double z) {
  std::size_t i = 0;
  while (i < ground.size() && (ground[i].x <= crest_x || ground[i].z > z)) ++i;
  return i;
}

/// The line held to at most `top` from index `from` on, with the points where it crosses added.
void append_lowered(Polyline& out, const Polyline& ground, std::size_t from, double top) {
  for (std::size_t i = from; i < ground.size(); ++i) {
    const Point& a = ground[i - 1];
    const Point& b = ground[i];
    if ((a.z > top) != (b.z > top)) out.push_back(between(a, b, top));
    out.push_back({b.x, std::min(b.z, top)});
  }
}

/// The cut for a bank whose toe lies right of its crest.
Polyline cut_rightwards(const Polyline& ground, const Point& crest, const Point& toe,
                        double height) {
  const double top = toe.z + std::min(height, crest.z - toe.z);
  const std::size_t below = first_at_or_below(ground, crest.x, top);
  if (below == 0 || below == ground.size()) return ground;
  const Point& above = ground[below - 1];
  const Point face = above.z > top ? between(above, ground[below], top) : ground[below];
  Polyline cut(ground.begin(), ground.begin() + static_cast<std::ptrdiff_t>(below));
  cut.push_back(face);
  cut.push_back({face.x, toe.z});
  append_lowered(cut, ground, below, toe.z);
  std::erase_if(cut, [&](const Point& p) { return p.x < face.x && p.z < toe.z && p.x > crest.x; });
  const auto repeated = std::unique(cut.begin(), cut.end());
  cut.erase(repeated, cut.end());
  return cut;
}

}  // namespace

std::optional<CrestAndToe> bank_of(const Section& section) {
  if (section.crest && section.toe) return CrestAndToe{*section.crest, *section.toe};
  auto bank = find_crest_and_toe(section.ground);
  if (bank && section.crest) bank->crest = *section.crest;
  if (bank && section.toe) bank->toe = *section.toe;
  return bank;
}

Polyline ground_after_toe_cut(const Polyline& ground, const CrestAndToe& bank, double height_m) {
  if (bank.toe.x >= bank.crest.x) return cut_rightwards(ground, bank.crest, bank.toe, height_m);
  return mirrored(cut_rightwards(mirrored(ground), {-bank.crest.x, bank.crest.z},
                                 {-bank.toe.x, bank.toe.z}, height_m));
}

}  // namespace leda::solver
