#include "solver/ensemble/chance.hpp"

#include <cmath>

namespace leda::solver {
namespace {

struct Moments {
  double mean = 0;
  double squares = 0;  ///< sum of (value - mean)^2
  std::size_t count = 0;

  std::optional<double> variance() const {
    if (count < 2) return std::nullopt;
    return squares / static_cast<double>(count - 1);
  }
  std::optional<double> standard_error() const {
    const auto v = variance();
    if (!v) return std::nullopt;
    return std::sqrt(*v / static_cast<double>(count));
  }
};

Moments moments_of(const std::vector<double>& values) {
  Moments m;
  m.count = values.size();
  for (const double v : values) m.mean += v / static_cast<double>(values.size());
  for (const double v : values) m.squares += (v - m.mean) * (v - m.mean);
  return m;
}

}  // namespace

std::optional<ChanceShare> chance_share(const std::vector<std::vector<double>>& repeats,
                                        const std::vector<double>& all) {
  ChanceShare chance;
  double squares = 0, freedom = 0;
  for (const auto& member : repeats) {
    if (member.size() < 2) continue;
    ++chance.members;
    chance.runs += member.size();
    squares += moments_of(member).squares;
    freedom += static_cast<double>(member.size() - 1);
  }
  if (chance.members == 0) return std::nullopt;
  chance.sd_m = std::sqrt(squares / freedom);
  const auto total = moments_of(all).variance();
  if (total && *total > 0) chance.share = chance.sd_m * chance.sd_m / *total;
  return chance;
}

std::optional<CellShift> cell_shift(const std::vector<CellPair>& pairs) {
  if (pairs.empty()) return std::nullopt;
  std::vector<double> differences, ratios;
  CellShift shift;
  shift.pairs = pairs.size();
  for (const CellPair& pair : pairs) {
    differences.push_back(pair.fine_m - pair.coarse_m);
    const bool coarse = pair.coarse_m > 0, fine = pair.fine_m > 0;
    if (coarse && fine) ratios.push_back(std::log(pair.fine_m / pair.coarse_m));
    if (coarse && !fine) ++shift.only_coarse_slid;
    if (!coarse && fine) ++shift.only_fine_slid;
  }
  const Moments m = moments_of(differences), ln = moments_of(ratios);
  shift.mean_m = m.mean;
  shift.standard_error_m = m.standard_error();
  shift.both_slid = ratios.size();
  if (!ratios.empty()) shift.mean_ln_ratio = ln.mean;
  shift.standard_error_ln = ln.standard_error();
  return shift;
}

}  // namespace leda::solver
