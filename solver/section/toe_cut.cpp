#include "solver/section/toe_cut.hpp"

#include <algorithm>

namespace leda {

std::optional<CrestAndToe> bank_in_use(const Section& section) {
  if (section.crest && section.toe) return CrestAndToe{*section.crest, *section.toe};
  auto bank = find_crest_and_toe(section.ground);
  if (bank && section.crest) bank->crest = *section.crest;
  if (bank && section.toe) bank->toe = *section.toe;
  return bank;
}

Polyline toe_cut(const Section& section, const CrestAndToe& bank, double height_m) {
  const double way = bank.crest.x - bank.toe.x;
  const int pieces = 2000;
  double face = bank.crest.x;
  for (int i = 1; i <= pieces; ++i) {
    const double x = bank.toe.x + way * i / pieces;
    if (elevation_at(section.ground, x) - bank.toe.z >= height_m) {
      face = x;
      break;
    }
  }
  const double top = std::max(bank.crest.z, bank.toe.z + height_m) + 1;
  return {{bank.toe.x, bank.toe.z}, {face, bank.toe.z}, {face, top}, {bank.toe.x, top}};
}

}  // namespace leda
