#pragma once
// The clay of a site as a material of a case, so that one set of rules says which numbers are
// impossible and which odd.

#include <string>
#include <vector>

#include "solver/screening/site.hpp"
#include "solver/section/material.hpp"
#include "solver/section/validate.hpp"

namespace leda::solver {

/// Faults of the clay's numbers (solver/section/validate.hpp), with the pointers of a site file.
std::vector<Fault> faults_of_clay(const Site& site);

/// What is odd but possible: the clay as in a case, the bank, and what a case does not have.
std::vector<std::string> warnings_of(const Site& site);

}  // namespace leda::solver
