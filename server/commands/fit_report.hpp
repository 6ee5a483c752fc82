#pragma once
// What `leda fit` was asked for, found, and says.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "solver/element_test/fit_strain_95.hpp"
#include "solver/element_test/fit_urmi.hpp"

namespace leda::server {

struct FitOptions {
  std::string file;
  double remolded_kPa = 0;
  std::optional<double> residual_kPa;
  std::optional<double> peak_kPa;
  std::optional<double> preconsolidation_kPa;
  double residual_share_percent = 100 * solver::residual_share_of_table_3_4;
  double specimen_m = 0.014;
  bool fit_residual = false;
  std::string strain = "plastic";
  std::string out;
  std::string svg;
  bool as_json = false;
};

struct Fits {
  solver::PostPeak curve;
  solver::UrmiFit urmi;
  solver::Strain95Fit strain_95;
  std::vector<std::string> warnings;  ///< magnitudes of the clay that few have
};

/// Everything found, with the softening blocks as a case file takes them.
nlohmann::json fit_document(const Fits& fits, const FitOptions& options);

/// The same for a person, on standard output.
void print_fits(const Fits& fits, const FitOptions& options);

/// Measured and fitted stress over strain, CSV.
std::string fit_table(const Fits& fits, const FitOptions& options);

/// The same as a drawing, out to the remolded strain, SVG.
std::string fit_drawing(const Fits& fits, const FitOptions& options);

}  // namespace leda::server
