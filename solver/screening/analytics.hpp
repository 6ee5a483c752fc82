#pragma once
// Everything that closed formulas say about a site, in one plain struct. What an input is missing
// for is absent, and `missing` says why.

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "solver/screening/site.hpp"

namespace leda::solver {

/// One published condition for a large retrogressive slide.
struct Criterion {
  std::string name;         ///< authors and year
  std::optional<bool> met;  ///< absent: an input it needs is missing
  std::string why;          ///< its thresholds beside the site's numbers
};

/// J/m3 (= Pa, strain as a fraction).
struct RemoldingEnergies {
  std::optional<double> complete_curve;  ///< eqs 3-16/3-17 with the corrected limits
  std::optional<double> leroueil;        ///< eq. 3-15
  std::optional<double> linear;          ///< straight from the peak along the first slope
  std::optional<double> thesis_reading;  ///< what Table 3-5 prints; for eq. 3-22 `thesis` only
};

/// Retrogression by eq. 3-22 and its neighbours, m.
struct EmpiricalRetrogression {
  std::optional<double> urmi_2023_thesis;
  std::optional<double> urmi_2023_corrected;
  std::optional<std::array<double, 2>> urmi_2023_corrected_range;  ///< omega +- its spread
  std::optional<double> quinn_2011;
  std::optional<std::array<double, 2>> carson_lajoie_1981;
  std::optional<double> mitchell_markell_1974;
  std::optional<double> nve_1_15;
};

struct Analytics {
  std::optional<double> stability_number;
  std::optional<double> sensitivity;
  std::optional<double> brittleness_index;   ///< eq. 2-20
  std::optional<double> limit_state_energy;  ///< eq. 3-3, J/m3
  std::optional<double> peak_strain;         ///< as given, else from eqs 3-3 and 3-5; fraction
  std::optional<double> potential_energy;    ///< 2mH/3, J/m3
  RemoldingEnergies remolding;
  std::optional<double> destruction_index;  ///< E_P / E_R
  std::vector<Criterion> criteria;
  EmpiricalRetrogression retrogression;
  std::map<std::string, std::string> missing;  ///< name of the quantity: why it is absent
};

/// @return every number that the site's inputs allow; never throws
Analytics analyse(const Site& site);

}  // namespace leda::solver
