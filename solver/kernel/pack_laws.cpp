#include <algorithm>

#include "solver/kernel/packs.hpp"

namespace leda::solver {

PackLaws pack_laws(const LawTable& table, bool softer) {
  const auto narrow = [](const std::vector<double>& column) {
    std::vector<Real> result(column.size() + 2 * Pack::lanes);
    std::transform(column.begin(), column.end(), result.begin(),
                   [](double value) { return static_cast<Real>(value); });
    return result;
  };
  return {table.rows(),
          narrow(table.bulk),
          narrow(table.shear),
          narrow(table.peak),
          narrow(table.floor),
          narrow(table.amplitude),
          narrow(table.rate),
          narrow(table.exp_end),
          narrow(table.line_start),
          narrow(table.line_slope),
          narrow(table.line_end),
          narrow(table.last),
          softer};
}

}  // namespace leda::solver
