#pragma once
// What `leda dss` and `leda calibrate` share: one material of a case file, at one place.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "solver/section/material.hpp"

namespace leda::server {

/// Options of the command line.
struct ElementOptions {
  std::string case_file;
  std::string material;
  std::optional<double> cell_m;
  std::optional<double> depth_m;
  std::optional<double> elevation_m;
};

/// @param cell_is_required calibrate has no cell to fall back on
void add_element_options(CLI::App& command, ElementOptions& options, bool cell_is_required);

struct ElementCase {
  std::string name;  ///< of the material
  Material material;
  double peak_Pa = 0;  ///< s_up at the place asked for
  double case_cell_m = 0;
  std::vector<std::string> warnings;  ///< of the material
};

/// Reads the case and picks the material. Faults and warnings are printed to stderr, each on its
/// line.
/// @return nothing where there was a fault (exit code 2)
std::optional<ElementCase> read_element_case(const ElementOptions& options);

/// Prints faults of a command, each on its line: "leda dss: ...".
void print_faults(const std::string& command, const std::vector<std::string>& faults);

/// Writes a file, or standard output where the path is empty or "-".
/// @return false where it could not be written, which is told on stderr
bool write_text(const std::string& path, const std::string& text);

}  // namespace leda::server
