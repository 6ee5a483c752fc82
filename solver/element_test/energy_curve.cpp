#include "solver/element_test/energy_curve.hpp"

namespace leda::solver {

double limit_state_energy(double preconsolidation_Pa) { return 0.013 * preconsolidation_Pa; }

LabCurve to_stress_strain(const EnergyCurve& curve, double peak_Pa, double remolded_Pa,
                          double preconsolidation_Pa) {
  const double limit_energy = limit_state_energy(preconsolidation_Pa);
  LabCurve result{{0, 2 * limit_energy / peak_Pa}, {0, peak_Pa}};
  double energy_before = limit_energy;
  for (std::size_t i = 0; i < curve.normalized_energy.size(); ++i) {
    const double energy = curve.normalized_energy[i] * limit_energy;
    const double stress = peak_Pa - curve.remolding_index[i] * (peak_Pa - remolded_Pa);
    const double mean = (result.stress_Pa.back() + stress) / 2;
    result.strain.push_back(result.strain.back() + (energy - energy_before) / mean);
    result.stress_Pa.push_back(stress);
    energy_before = energy;
  }
  return result;
}

}  // namespace leda::solver
