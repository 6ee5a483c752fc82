#pragma once
// Curves of the laboratory, and the CSV file they come in.

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace leda::solver {

/// Stress over total engineering shear strain, as a direct simple shear test gives it.
struct LabCurve {
  std::vector<double> strain;     ///< fraction, never falling
  std::vector<double> stress_Pa;  ///< shear stress
};

/// Remolding index over strain energy (Tavenas et al. 1983; thesis eqs 3-1, 3-2).
struct EnergyCurve {
  std::vector<double> remolding_index;    ///< I_r, fraction
  std::vector<double> normalized_energy;  ///< w_N = W / w_LS, a ratio, never falling
};

/// What a file held: one of the two curves, or the faults that keep it from being one.
struct LabFile {
  std::optional<LabCurve> stress_strain;
  std::optional<EnergyCurve> energy;
  std::vector<std::string> faults;  ///< all of them (at most 20), each with its line
};

/// Reads a comma separated file with one header line; lines starting with # and empty ones are
/// skipped, columns that are not asked for too. The header names the columns and their units:
///   shear_strain or shear_strain_percent, with shear_stress_kPa
///   normalized_energy or normalized_energy_percent, with remolding_index or ..._percent
LabFile read_lab_file(std::istream& in);

}  // namespace leda::solver
