// The rule. Ground that falls less than 1 in 10 is not part of a face. Of all stretches between
// two points of the ground, the bank is the one whose drop exceeds that of a 1-in-10 slope over
// the same distance by most: it starts where the ground turns steeper (the break from plateau to
// face), ends where it turns flatter (the break from face to valley floor), and runs across a
// bench or a bump that costs less than the face behind it brings. High and steep banks win over
// low and gentle ones, on whichever side they are.
//
// Real slopes are rounded, so a second pass within that bank raises the limit to a third of the
// slope of its steepest third (of the height), at most to 1 in 5: gentle ground above the crest and
// talus below the toe are left out, a face that is steep below and 12 degrees above is kept whole.

#include "solver/section/crest_and_toe.hpp"

#include <algorithm>
#include <cstddef>

namespace leda {
namespace {

constexpr double flattest_face = 0.1;  ///< slope, rise over run
constexpr double steepest_limit = 0.2;
constexpr double share_of_steepest = 1.0 / 3;

struct Stretch {
  std::size_t first = 0;
  std::size_t last = 0;
  double excess_m = 0;  ///< drop beyond that of the limiting slope
};

// Greatest sum of a run (Kadane): `first` is the best start for every end. Ground falls rightwards.
Stretch steepest_stretch(const Polyline& ground, std::size_t from, std::size_t to, double limit) {
  const auto height = [&](std::size_t i) { return ground[i].z + limit * ground[i].x; };
  Stretch best{from, from, 0};
  std::size_t start = from;
  for (std::size_t i = from + 1; i <= to; ++i) {
    if (height(i) >= height(start)) {
      start = i;
      continue;
    }
    const double excess = height(start) - height(i);
    if (excess > best.excess_m) best = {start, i, excess};
  }
  return best;
}

// Slope of the shortest stretch between two points of the bank that holds a third of its drop.
double slope_of_steepest_third(const Polyline& ground, const Stretch& bank) {
  const double third = (ground[bank.first].z - ground[bank.last].z) / 3;
  double steepest = 0;
  for (std::size_t i = bank.first; i < bank.last; ++i) {
    for (std::size_t j = i + 1; j <= bank.last; ++j) {
      const double drop = ground[i].z - ground[j].z;
      if (drop < third) continue;
      const double run = ground[j].x - ground[i].x;
      steepest = std::max(steepest, run > 0 ? drop / run : 1e3);
      break;
    }
  }
  return steepest;
}

Stretch bank_falling_right(const Polyline& ground) {
  Stretch bank = steepest_stretch(ground, 0, ground.size() - 1, flattest_face);
  if (bank.first == bank.last) return bank;
  const double limit = std::clamp(share_of_steepest * slope_of_steepest_third(ground, bank),
                                  flattest_face, steepest_limit);
  const Stretch face = steepest_stretch(ground, bank.first, bank.last, limit);
  if (face.first != face.last) {
    bank.first = face.first;
    bank.last = face.last;
  }
  return bank;
}

Polyline mirrored(const Polyline& ground) {
  Polyline result(ground.rbegin(), ground.rend());
  for (Point& p : result) p.x = -p.x;
  return result;
}

}  // namespace

std::optional<CrestAndToe> find_crest_and_toe(const Polyline& ground, double least_height_m,
                                              Facing facing) {
  if (ground.size() < 2) return std::nullopt;
  const Stretch right = facing == Facing::left ? Stretch{} : bank_falling_right(ground);
  const Stretch left = facing == Facing::right ? Stretch{} : bank_falling_right(mirrored(ground));

  const std::size_t end = ground.size() - 1;
  const CrestAndToe bank = right.excess_m >= left.excess_m
                               ? CrestAndToe{ground[right.first], ground[right.last]}
                               : CrestAndToe{ground[end - left.first], ground[end - left.last]};
  if (bank.crest.z - bank.toe.z < least_height_m) return std::nullopt;
  return bank;
}

bool falls_right(const Polyline& ground, const CrestAndToe& bank) {
  const double x = bank.crest.x;
  if (x != bank.toe.x) return x < bank.toe.x;
  const auto first = std::ranges::lower_bound(ground, x, {}, &Point::x);
  const auto beyond = std::ranges::upper_bound(ground, x, {}, &Point::x);
  if (beyond - first > 1 && first->z != (beyond - 1)->z) return first->z > (beyond - 1)->z;
  return ground.front().z > ground.back().z;
}

}  // namespace leda
